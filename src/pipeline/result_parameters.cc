#include "prosup/pipeline/result_parameters.h"

namespace prosup::pipeline {

using namespace dealii;

ResultParameters::ResultParameters() : ParameterAcceptor("Results") {}

void ResultParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Voxel edge", voxel_edge,
                    "Edge of the voxels of the common unloaded grid, on which the unloaded images "
                    "and the fields from the unloaded state are given. Units: mm.",
                    Patterns::Double(0.05, 50.));
  prm.add_parameter("Margin", margin,
                    "Space that this grid leaves around both unloaded meshes. Units: mm.",
                    Patterns::Double(0., 1000.));
  prm.add_parameter("Pictures", pictures, "Write PNG pictures of slices.");
}

} // namespace prosup::pipeline
