#ifndef PROSUP_PHANTOM_STATE_IMAGES_H
#define PROSUP_PHANTOM_STATE_IMAGES_H

#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"
#include "prosup/phantom/texture.h"

namespace prosup::phantom {

/// Where in the unloaded configuration the tissue in each voxel comes from.
struct MaterialPoints {
  image::VectorImage to_unloaded; ///< X - x, mm, where there is tissue
  image::LabelImage in_tissue;    ///< 1 where the centre lies in the mesh
};

/// Looks the voxel centres up in the loaded configuration of a mesh.
MaterialPoints material_points(const image::VoxelGrid& grid, const mesh::UnloadedMesh& mesh);

/// What spoils an image.
struct ImageErrors {
  double noise = 0.;      ///< standard deviation, Rician for MR, else Gaussian
  double bias_field = 0.; ///< standard deviation of the logarithm of a smooth factor; MR only
};

/// Makes the image and the labels of a state from its material points. `state`
/// numbers the state, for the random numbers.
class StateImages {
public:
  StateImages(const Anatomy& anatomy, const MaterialPoints& points, std::uint64_t seed,
              unsigned state);

  image::LabelImage labels() const;
  image::ScalarImage image(const Texture& texture, Modality modality,
                           const ImageErrors& errors) const;
  /// The labels with all boundaries displaced by a smooth random field of this
  /// standard deviation, mm.
  image::LabelImage jittered_labels(double jitter) const;

private:
  Point<3> unloaded(std::size_t voxel, const Point<3>& x) const;
  Label label_at(std::size_t voxel, const Point<3>& x) const;

  const Anatomy& anatomy_;
  const MaterialPoints& points_;
  const std::uint64_t seed_;
  const unsigned state_;
};

} // namespace prosup::phantom

#endif
