#include "prosup/mechanics/body/element.h"

#include "prosup/core/parameters.h"

namespace prosup::mechanics {

using namespace dealii;

const std::vector<std::string>& element_names() {
  static const std::vector<std::string> names{"linear", "nodal-pressure", "quadratic"};
  return names;
}

const std::vector<std::string>& precision_names() {
  static const std::vector<std::string> names{"double", "float"};
  return names;
}

const std::vector<std::string>& instruction_set_names() {
  static const std::vector<std::string> names{"baseline", "AVX2", "AVX-512"};
  return names;
}

ElementParameters::ElementParameters()
    : ParameterAcceptor("Elements"), type_("nodal-pressure"),
      precision_(precision_names().front()) {}

void ElementParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter(
      "Type", type_,
      "Finite element. nodal-pressure: 4-node tetrahedra with volume changes averaged at the "
      "nodes (Joldes et al. 2009), which do not lock near incompressibility. linear: 4-node "
      "tetrahedra without this averaging, a little faster. quadratic: 10-node tetrahedra, the most "
      "accurate on a given mesh; edges can be about twice as long.",
      one_of(element_names()));
  prm.add_parameter("Precision", precision_,
                    "Floating-point precision of the internal forces; positions are always double.",
                    one_of(precision_names()));
  std::vector<std::string> sets = instruction_set_names();
  sets.insert(sets.begin(), "best");
  prm.add_parameter("Instruction set", instruction_set_,
                    "Processor instructions used for the internal forces. best: the best that "
                    "this processor has. With a named set, results are equal to the last digit on "
                    "all processors that have it.",
                    one_of(sets));
}

Element ElementParameters::element() const {
  return {enumerator<ElementType>(type_, element_names()),
          enumerator<Precision>(precision_, precision_names()), instruction_set_};
}

} // namespace prosup::mechanics
