#ifndef PROSUP_REGISTRATION_SCENE_PAIR_H
#define PROSUP_REGISTRATION_SCENE_PAIR_H

#include <optional>

#include "prosup/core/position.h"
#include "prosup/registration/inputs.h"
#include "scene_breast.h"
#include "scene_maps.h"

namespace prosup::registration {

/// Median scaled intensities of fat and gland.
struct TissueContrast {
  double fat = 0., gland = 0.;
};

/// What two images of a breast say about each other without any simulation.
struct PairMeasures {
  double facing = 0.;       ///< cosine of the angle between the two fronts
  double gravity_angle = 0; ///< between the two directions, degrees
  /// Of the points of the base of one breast, the share that lies in the image of the other.
  PerPosition<double> in_view;
  /// Distances of these points from the chest of the other image, mm; nothing without any.
  std::optional<double> chest_median, chest_p90;
  double volume_ratio = 0., gland_ratio = 0., width_ratio = 0.; ///< prone to supine
  std::optional<double> reach_ratio;
  ViewFit fit;
  Turned information; ///< mutual, of the intensities in the chest wall, nats
  PerPosition<std::optional<TissueContrast>> contrast;
  double common_histogram = 1.; ///< share of the intensities that both breasts have
  bool same_image = false, same_labels = false;
  PerPosition<std::size_t> n_values; ///< different intensities in the tissue, counted up to a few
};

/// Whether the centres of the voxels of a grid surround a point.
bool lies_within(const image::VoxelGrid& grid, const dealii::Point<3>& x);

/// The mutual information of two thinned images in the chest wall, which does not deform.
Turned chest_information(const PerPosition<BreastMeasures>& breasts,
                         const PerPosition<image::ScalarImage>& images);

PairMeasures compare(const PerPosition<BreastMeasures>& breasts, const Inputs& inputs,
                     const PerPosition<dealii::Tensor<1, 3>>& gravity, const Labels& meaning,
                     double edge);

} // namespace prosup::registration

#endif
