#ifndef PROSUP_SIMILARITY_DOMAIN_H
#define PROSUP_SIMILARITY_DOMAIN_H

#include <mpi.h>

#include <array>

#include "prosup/similarity/image_force.h"

namespace prosup::similarity {

/// A grid with axes along LPS and the given spacing (mm) that holds the
/// unloaded meshes of both states and `margin` mm around them. Collective on
/// `communicator`.
image::VoxelGrid common_unloaded_grid(const std::array<LoadedState, 2>& states, double spacing,
                                      double margin, MPI_Comm communicator);

/// What is known of the scene around the two bodies.
struct Scene {
  std::array<image::LabelImage, 2> labels;   ///< of the loaded states
  std::array<image::LabelImage, 2> excluded; ///< not 0 where there is no force; may be empty
  std::array<float, 2> air{0.f, 0.f};        ///< intensity of air in the scaled images
  unsigned chest_label = 1;
  unsigned gland_label = 3;
};

/// The domain on `grid`: voxels in the chest of either label image, or beyond
/// a face of its field of view that the body touches, do not count as air.
SimilarityDomain similarity_domain(const image::VoxelGrid& grid, const Scene& scene,
                                   unsigned n_layers);

} // namespace prosup::similarity

#endif
