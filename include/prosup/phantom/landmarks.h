#ifndef PROSUP_PHANTOM_LANDMARKS_H
#define PROSUP_PHANTOM_LANDMARKS_H

#include <array>
#include <cstdint>
#include <vector>

#include "prosup/evaluation/landmarks.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"
#include "prosup/phantom/geometry.h"

namespace prosup::phantom {

/// Landmarks uniformly at random in the unloaded tissue, such that both loaded
/// positions lie between the voxel centres of their images (0 prone, 1 supine;
/// the meshes differ in their loaded positions only).
/// @throws Error if the fields of view show too little tissue.
std::vector<evaluation::Landmark> sample_landmarks(const Geometry& geometry,
                                                   const std::array<mesh::UnloadedMesh, 2>& meshes,
                                                   const std::array<image::VoxelGrid, 2>& grids,
                                                   unsigned n_landmarks, std::uint64_t seed);

} // namespace prosup::phantom

#endif
