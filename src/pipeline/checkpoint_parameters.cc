#include "prosup/pipeline/checkpoint_parameters.h"

namespace prosup::pipeline {

using namespace dealii;

CheckpointParameters::CheckpointParameters() : ParameterAcceptor("Checkpoint") {}

void CheckpointParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Write", wanted,
                    "Whether register, unload and load keep their state in files, from which "
                    "--restart goes on after the run was ended.");
  prm.add_parameter("Interval", interval,
                    "Least time between two checkpoints. They are written at the ends of stages, "
                    "and at accepted steps within them. It grows where they would take more than "
                    "1 % of the time; 0 writes one wherever it is possible. Units: s.",
                    Patterns::Double(0., 1e6));
  prm.add_parameter("Folder", folder_,
                    "Folder for the checkpoints. If empty, the output folder with '.checkpoint' "
                    "added to its name. It is removed when the run ends well.",
                    Patterns::Anything());
}

std::filesystem::path CheckpointParameters::folder_for(const std::filesystem::path& output) const {
  if (!folder_.empty())
    return std::filesystem::absolute(folder_).lexically_normal();
  std::filesystem::path target = std::filesystem::absolute(output).lexically_normal();
  if (!target.has_filename())
    target = target.parent_path();
  return target.parent_path() / (target.filename().string() + ".checkpoint");
}

} // namespace prosup::pipeline
