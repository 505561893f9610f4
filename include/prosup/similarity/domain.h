#ifndef PROSUP_SIMILARITY_DOMAIN_H
#define PROSUP_SIMILARITY_DOMAIN_H

#include <mpi.h>

#include <limits>
#include <vector>

#include "prosup/core/position.h"
#include "prosup/image/voxel_image.h"

namespace prosup::similarity {

/// The smallest box that holds some points; empty at first.
struct Box {
  void include(const dealii::Point<3>& point);
  void include(const Box& other);
  /// Moves all faces outwards by `distance` (mm).
  void grow(double distance);

  static constexpr double far = std::numeric_limits<double>::max();
  dealii::Point<3> low{far, far, far}, high{-far, -far, -far};
};

/// The grid with axes along LPS and the given spacing (mm) that holds the boxes of all ranks and
/// `margin` mm around them. Collective on `communicator`.
image::VoxelGrid common_grid(const Box& box, double spacing, double margin, MPI_Comm communicator);

/// The surroundings of the two breasts, as far as the images show them.
struct Scene {
  PerPosition<image::LabelImage> labels;   ///< of the loaded breasts
  PerPosition<image::LabelImage> excluded; ///< not 0 where there is no force; may be empty
  PerPosition<float> air{0.f, 0.f};        ///< intensity of air in the scaled images
  unsigned chest_label = 1;
  unsigned gland_label = 3;
  unsigned unknown_label = 0; ///< of what the image does not show; 0: it is not marked
};

/// What is the same for all evaluations on one grid.
struct SimilarityDomain {
  image::VoxelGrid grid;
  /// Voxels in which an image without tissue does not count as air: the chest, and what lies
  /// beyond the field of view. Empty: none.
  std::vector<bool> no_air;
  unsigned n_layers = 2;            ///< voxels added around each mesh
  PerPosition<float> air{0.f, 0.f}; ///< intensity of voxels without a sample
  /// Labels of the loaded images that are not 0 where no force is computed; either may be empty.
  /// Null: none. Has to live as long as the domain.
  const PerPosition<image::LabelImage>* excluded = nullptr;
};

/// The domain on `grid`. Voxels in the chest of either label image, or beyond a face of its field
/// of view that the body touches, do not count as air.
SimilarityDomain similarity_domain(const image::VoxelGrid& grid, const Scene& scene,
                                   unsigned n_layers);

} // namespace prosup::similarity

#endif
