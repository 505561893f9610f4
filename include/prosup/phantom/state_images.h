#ifndef PROSUP_PHANTOM_STATE_IMAGES_H
#define PROSUP_PHANTOM_STATE_IMAGES_H

#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"
#include "prosup/phantom/texture.h"

namespace prosup::phantom {

/// The unloaded position of the tissue in each voxel of a loaded image.
struct MaterialPoints {
  image::VectorImage to_unloaded; ///< X - x, mm, in tissue
  image::LabelImage in_tissue;    ///< 1 where the centre lies in the mesh
};

/// Finds the voxel centres in the loaded configuration of a mesh.
MaterialPoints material_points(const image::VoxelGrid& grid, const mesh::UnloadedMesh& mesh);

/// Noise and bias field of an image.
struct ImageErrors {
  double noise = 0.;      ///< standard deviation, Rician for MR, else Gaussian
  double bias_field = 0.; ///< standard deviation of the logarithm of a smooth factor; MR only
};

/// Makes the image and the labels of a configuration from its material points. `state` is the
/// number of the image, 0 to 2, which selects its random numbers.
class StateImages {
public:
  StateImages(const Anatomy& anatomy, const MaterialPoints& points, std::uint64_t seed,
              unsigned state);

  image::LabelImage labels() const;
  image::ScalarImage image(const Texture& texture, Modality modality,
                           const ImageErrors& errors) const;
  /// The labels with their boundaries displaced by a smooth random field with the standard
  /// deviation `jitter`, mm.
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
