#include "prosup/pipeline/single_state_parameters.h"

#include "prosup/core/parameters.h"

namespace prosup::pipeline {

using namespace dealii;

SingleStateParameters::SingleStateParameters() : ParameterAcceptor("Single state") {}

void SingleStateParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter(
      "Solver", solver_,
      "Solver of load and unload. explicit: damped motion (section Unloading). newton: "
      "Newton's method (section Quasi-static).",
      Patterns::Selection("explicit|newton"));
  prm.add_parameter("Mesh", mesh,
                    "Mesh from whose unloaded configuration load starts: <state>_loaded.vtu of a "
                    "result of unload "
                    "or register. If empty, the labels are taken as the unloaded shape and meshed.",
                    Patterns::Anything());
}

void SingleStateParameters::resolve(const std::filesystem::path& folder, ParameterHandler& prm) {
  resolve_files(prm, get_section_name(), {"Mesh"}, folder);
}

} // namespace prosup::pipeline
