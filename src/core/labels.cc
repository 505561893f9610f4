#include "prosup/core/labels.h"

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <set>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup {

using namespace dealii;

namespace {

constexpr unsigned largest_label = 255;             // label images have 8 bits
constexpr unsigned default_unknown = largest_label; // as in the header

void require_value(unsigned label, const char* entry) {
  if (label < 1 || label > largest_label)
    throw Error(format("'Labels/%s' is %u; give a value from 1 to %u, because 0 is air.", entry,
                       label, largest_label));
}

} // namespace

Labels::Labels() : ParameterAcceptor("Labels") {}

void Labels::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Chest", chest,
                    "Label of the chest wall and its muscle. The boundary of the breast is chest "
                    "wall where tissue touches this label.",
                    Patterns::Integer(0, largest_label));
  prm.add_parameter("Tissues", tissues,
                    "Labels of the breast tissues, fat and gland. They are meshed.",
                    Patterns::List(Patterns::Integer(0, largest_label), 1, largest_label));
  prm.add_parameter("Gland", gland,
                    "Which of the tissues is gland. The material update may find how much stiffer "
                    "it is than the others. 0: the labels do not mark gland.",
                    Patterns::Integer(0, largest_label));
  prm.add_parameter("Unknown", unknown,
                    "Label of what the image does not show, such as the outside of a "
                    "reconstruction circle. Tissue that touches it is cut off there, as by the "
                    "border of the image. 0: the labels do not mark it.",
                    Patterns::Integer(0, largest_label));
}

void Labels::parse_parameters(ParameterHandler&) {
  // Masks that have 255 for tissue do not mark what is unknown by it.
  const bool is_tissue = std::find(tissues.begin(), tissues.end(), unknown) != tissues.end();
  if (unknown == default_unknown && (is_tissue || unknown == chest))
    unknown = 0;
  check();
}

void Labels::check() const {
  require_value(chest, "Chest");
  if (tissues.empty())
    throw Error("'Labels/Tissues' is empty; name at least one label of breast tissue.");
  std::set<unsigned> used{chest};
  for (const unsigned tissue : tissues) {
    require_value(tissue, "Tissues");
    if (!used.insert(tissue).second)
      throw Error(format("The label %u has two meanings in 'Labels/Chest' and 'Labels/Tissues'; "
                         "give each label once.",
                         tissue));
  }
  if (unknown != 0 && used.count(unknown) > 0)
    throw Error(format("The label %u of 'Labels/Unknown' is also one of the chest or of a tissue; "
                       "give another, or 0 if the labels do not mark what is unknown.",
                       unknown));
  if (gland != 0 && std::find(tissues.begin(), tissues.end(), gland) == tissues.end())
    throw Error(format("'Labels/Gland' is %u, which is none of 'Labels/Tissues'; give one of them, "
                       "or 0 if the label images do not mark gland.",
                       gland));
}

unsigned Labels::fat() const {
  const auto found = std::find_if(tissues.begin(), tissues.end(),
                                  [&](unsigned tissue) { return tissue != gland; });
  if (found == tissues.end())
    throw Error("'Labels/Tissues' names no tissue but gland; add the label of fat.");
  return *found;
}

} // namespace prosup
