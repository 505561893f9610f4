#ifndef PROSUP_BENCHMARKS_BOX_EXPERIMENT_UNLOAD_H
#define PROSUP_BENCHMARKS_BOX_EXPERIMENT_UNLOAD_H

#include "cube.h"
#include "prosup/image/voxel_image.h"

namespace prosup::benchmarks {

/// What both ways of unloading use: the default of the program.
constexpr mechanics::ElementType box_element = mechanics::ElementType::nodal_pressure;

/// Loads a mesh of 5 n^3 tetrahedra of the cube by the explicit method, unloads
/// the loaded mesh, and returns the distances (mm) of its nodes from where they
/// started.
/// @throws DivergenceError if either does not settle.
std::vector<double> same_mesh_errors(const BoxExperiment& box, unsigned n);

/// The mesh of a mask and its unloaded positions, explicit. @throws as above.
mesh::UnloadedMesh unload_mask(const BoxExperiment& box, const image::LabelImage& mask,
                               double edge_length);

} // namespace prosup::benchmarks

#endif
