#include "prosup/pipeline/single_state_parameters.h"

#include "prosup/core/parameters.h"

namespace prosup::pipeline {

using namespace dealii;

SingleStateParameters::SingleStateParameters() : ParameterAcceptor("Single state") {}

void SingleStateParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Solver", solver_,
                    "How load and unload find equilibrium. explicit: damped motion (section "
                    "Unloading), newton: Newton's method (section Quasi-static).",
                    Patterns::Selection("explicit|newton"));
  prm.add_parameter(
      "Mesh", mesh,
      "Mesh whose unloaded configuration load starts from: <state>_loaded.vtu of a result "
      "of unload or register. Without it the labels of the state are taken for its "
      "unloaded shape and meshed.",
      Patterns::Anything());
}

void SingleStateParameters::resolve(const std::filesystem::path& folder, ParameterHandler& prm) {
  resolve_files(prm, get_section_name(), {"Mesh"}, folder);
}

} // namespace prosup::pipeline
