#include "prosup/pipeline/case_parameters.h"

#include "prosup/core/error.h"
#include "prosup/core/parameters.h"
#include "prosup/similarity/metric.h"

namespace prosup::pipeline {

using namespace dealii;
using similarity::state_names;

namespace {

std::string capitalized(const char* word) {
  std::string text(word);
  text[0] = static_cast<char>(std::toupper(text[0]));
  return text;
}

void require(const std::string& value, const std::string& entry, const std::string& option) {
  if (value.empty())
    throw Error("No file is given for '" + entry +
                "'; name it in the parameter file (section "
                "Case) or with " +
                option + " FILE.");
}

} // namespace

CaseParameters::CaseParameters() : ParameterAcceptor("Case"), chest_("sliding") {
  gravity[0][1] = -1.;
  gravity[1][1] = 1.;
}

void CaseParameters::declare_parameters(ParameterHandler& prm) {
  for (unsigned s = 0; s < 2; ++s) {
    const std::string state = capitalized(state_names[s]);
    prm.add_parameter(state + " image", images[s],
                      "Image of the loaded " + std::string(state_names[s]) +
                          " breast: NIfTI, NRRD or MetaImage.",
                      Patterns::Anything());
    prm.add_parameter(state + " labels", labels[s],
                      "Its labels on the same voxels: air, chest wall and muscle, fat, gland.",
                      Patterns::Anything());
    prm.add_parameter(state + " excluded", excluded[s],
                      "Mask on the same voxels: where it is not 0, the image gives no force, as "
                      "at marker clips. May be empty.",
                      Patterns::Anything());
    prm.add_parameter(state + " gravity", gravity[s],
                      "Direction of gravity, LPS. Units: none (its length does not matter).");
  }
  prm.add_parameter("Landmarks", landmarks,
                    "Landmarks for evaluation only, CSV: id,prone_x,...,supine_z. May be empty.",
                    Patterns::Anything());
  prm.add_parameter("Supine offset", supine_offset,
                    "Added to all supine coordinates (image, labels, landmarks) as they are read, "
                    "as if the patient lay elsewhere: tells how much a misaligned chest matters. "
                    "Units: mm.");
  prm.add_parameter("State", state_, "What the commands mesh, unload and load work on.",
                    Patterns::Selection("prone|supine"));
  prm.add_parameter("Chest", chest_,
                    "Motion of the tissue on the chest wall. fixed: none. sliding: along it. "
                    "one-sided: along it, and it may lift off. Units: none.",
                    one_of(unloading::chest_condition_names()));
  prm.add_parameter("Method", method_,
                    "Numerical method of register and unload. fe: finite elements. fdm: the "
                    "finite differences of the paper, for comparison.",
                    Patterns::Selection("fe|fdm"));
}

void CaseParameters::parse_parameters(ParameterHandler&) {
  for (unsigned s = 0; s < 2; ++s)
    if (!(gravity[s].norm() > 0.))
      throw Error("The direction 'Case/" + capitalized(state_names[s]) +
                  " gravity' is 0,0,0; give a direction in LPS, such as 0,-1,0 for prone and "
                  "0,1,0 for supine.");
}

unloading::ChestCondition CaseParameters::chest() const {
  return enumerator<unloading::ChestCondition>(chest_, unloading::chest_condition_names());
}

void CaseParameters::resolve(const std::filesystem::path& folder, ParameterHandler& prm) {
  resolve_files(prm, get_section_name(),
                {"Prone image", "Prone labels", "Prone excluded", "Supine image", "Supine labels",
                 "Supine excluded", "Landmarks"},
                folder);
}

void CaseParameters::require_pair() const {
  for (unsigned s = 0; s < 2; ++s) {
    const std::string state = state_names[s];
    require(images[s], "Case/" + capitalized(state_names[s]) + " image", "--" + state + "-image");
    require_labels(s);
  }
}

void CaseParameters::require_labels(unsigned s) const {
  require(labels[s], "Case/" + capitalized(state_names[s]) + " labels",
          "--" + std::string(state_names[s]) + "-labels");
}

} // namespace prosup::pipeline
