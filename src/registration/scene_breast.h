#ifndef PROSUP_REGISTRATION_SCENE_BREAST_H
#define PROSUP_REGISTRATION_SCENE_BREAST_H

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "prosup/core/labels.h"
#include "prosup/image/voxel_image.h"

namespace prosup::registration {

/// Every n-th voxel along each axis, such that voxels are about `edge` (mm) long or have their own
/// length if that is longer.
template <typename T>
image::VoxelImage<T> thinned(const image::VoxelImage<T>& image, double edge);

/// What the labels of one breast say without any simulation. Volumes and label counts are those of
/// all voxels, all else is measured on thinned ones.
struct BreastMeasures {
  std::array<std::size_t, 256> counts{}; ///< voxels of each label
  double voxel_ml = 0.;
  double tissue_ml = 0., gland_ml = 0.;
  /// Tissue on the thinned voxels divided by that on all; far from 1 if slices are missing.
  double solid = 0.;
  double largest_part = 0.; ///< share of the tissue in its largest connected part

  // Areas of voxel faces, mm^2.
  double base_area = 0.;      ///< between tissue and chest
  double skin_area = 0.;      ///< between tissue and air
  double gland_skin_area = 0; ///< the part of it that is gland
  double border_area = 0.;    ///< of tissue at the border of the image
  double front_area = 0.;     ///< the part of it that looks away from the chest

  /// Unit vector from the chest to the tissue, the mean normal of the base, and how far the normals
  /// agree: 1 for a plane, 0 for a closed surface.
  dealii::Tensor<1, 3> front;
  double agreement = 0.;
  double covered = 0.; ///< share of the shadow of the tissue along `front` that has chest behind it
  /// Distance from the chest below which 95 % of the tissue lies, mm; nothing without chest.
  std::optional<double> reach;

  image::LabelImage labels;           ///< thinned
  image::ScalarImage chest_distance;  ///< on them, mm; empty without chest
  std::vector<dealii::Point<3>> base; ///< centres of the faces between tissue and chest
};

BreastMeasures measure(const image::LabelImage& labels, const Labels& meaning, double edge);

/// Is it one of the tissues?
std::array<bool, 256> tissue_table(const Labels& meaning);

} // namespace prosup::registration

#endif
