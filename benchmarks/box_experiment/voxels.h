#ifndef PROSUP_BENCHMARKS_BOX_EXPERIMENT_VOXELS_H
#define PROSUP_BENCHMARKS_BOX_EXPERIMENT_VOXELS_H

#include "cube.h"
#include "prosup/image/voxel_image.h"

namespace prosup::benchmarks {

/// The mask (label 2) of the voxels whose centres lie in the mesh as loaded. The
/// face y = `border` is the border of the image, where the mesh from the mask is
/// cut and held; faces of voxels lie on multiples of `spacing` plus `shift` times
/// it in x and z. mm.
image::LabelImage rasterise(const mesh::TetMesh& mesh, double spacing, double border, double shift);

/// Distances, mm.
struct Distances {
  double max = 0., p95 = 0., mean = 0.;
};
Distances statistics(std::vector<double> values);

/// Distance between the unloaded positions that both meshes give to the centre of
/// each voxel of the mask.
std::vector<double> displacement_errors(const image::LabelImage& mask,
                                        const mesh::UnloadedMesh& recovered,
                                        const mesh::UnloadedMesh& truth);

/// Distances of the nodes of the free surface, unloaded, from that of the cube.
std::vector<double> surface_distances(const mesh::UnloadedMesh& recovered, double edge);

} // namespace prosup::benchmarks

#endif
