#include "prosup/pipeline/loading_parameters.h"

#include "prosup/core/parameters.h"

namespace prosup::pipeline {

using namespace dealii;

LoadingParameters::LoadingParameters() : ParameterAcceptor("Loading") {}

void LoadingParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Solver", solver_,
                    "explicit: settles by damped motion (section Unloading), newton: Newton's "
                    "method (section Quasi-static).",
                    Patterns::Selection("explicit|newton"));
  prm.add_parameter("Mesh", mesh,
                    "Mesh whose unloaded configuration is loaded: <state>_loaded.vtu of a result "
                    "of unload or register. Without it the labels of the state are taken for its "
                    "unloaded shape and meshed.",
                    Patterns::Anything());
}

void LoadingParameters::resolve(const std::filesystem::path& folder, ParameterHandler& prm) {
  resolve_files(prm, get_section_name(), {"Mesh"}, folder);
}

} // namespace prosup::pipeline
