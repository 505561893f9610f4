#ifndef PROSUP_PHANTOM_LANDMARKS_H
#define PROSUP_PHANTOM_LANDMARKS_H

#include <cstdint>
#include <vector>

#include "prosup/core/position.h"
#include "prosup/evaluation/landmarks.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"
#include "prosup/phantom/geometry.h"

namespace prosup::phantom {

/// Landmarks distributed uniformly at random in the unloaded tissue. Both loaded positions
/// lie between voxel centres of their images. The meshes differ only in their loaded
/// positions.
/// @throws Error if the images show too little tissue.
std::vector<evaluation::Landmark> sample_landmarks(const Geometry& geometry,
                                                   const PerPosition<mesh::UnloadedMesh>& meshes,
                                                   const PerPosition<image::VoxelGrid>& grids,
                                                   unsigned n_landmarks, std::uint64_t seed);

} // namespace prosup::phantom

#endif
