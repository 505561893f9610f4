#include "prosup/pipeline/result_parameters.h"

namespace prosup::pipeline {

using namespace dealii;

ResultParameters::ResultParameters() : ParameterAcceptor("Results") {}

void ResultParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Voxel edge", voxel_edge,
                    "Voxel edge of the unloaded grid, on which the unloaded images and the "
                    "displacement fields from the unloaded state are written. Units: mm.",
                    Patterns::Double(0.05, 50.));
  prm.add_parameter("Margin", margin, "Margin of this grid around both unloaded meshes. Units: mm.",
                    Patterns::Double(0., 1000.));
  prm.add_parameter("Other states", other_states,
                    "Whether each image is also written as it would look in the other position: "
                    "prone_in_supine.nii.gz and supine_in_prone.nii.gz.");
  prm.add_parameter("Pictures", pictures,
                    "Whether pictures of slices are written, as PNG and in the report.");
}

} // namespace prosup::pipeline
