#ifndef PROSUP_TESTS_SUPPORT_HALF_ELLIPSOIDS_H
#define PROSUP_TESTS_SUPPORT_HALF_ELLIPSOIDS_H

#include <cmath>
#include <cstdint>

#include "prosup/registration/inputs.h"

namespace prosup::tests {

/// A breast as half an ellipsoid on a flat chest, the surface of which is y = 0; the front is -y.
/// Its gland lies to the patient's left and above.
struct HalfEllipsoid {
  double height = 60., radius = 60.; ///< mm
  double centre = 0.;                ///< along x, mm
  std::uint8_t chest = 1, fat = 2, gland = 3;
  double half_width = 80.; ///< of the image along x and z, mm

  std::uint8_t label(const dealii::Point<3>& X) const {
    if (X[1] > 0.)
      return chest;
    const double x = X[0] - centre;
    const auto inside = [&](double x0, double z0, double size) {
      const double a = (x - x0) / (size * radius), b = X[1] / (size * height),
                   c = (X[2] - z0) / (size * radius);
      return a * a + b * b + c * c < 1.;
    };
    if (inside(0.2 * radius, 0.15 * radius, 0.5))
      return gland;
    return inside(0., 0., 1.) ? fat : 0;
  }

  image::LabelImage labels() const {
    constexpr double voxel = 4.;
    image::VoxelGrid grid;
    grid.spacing = dealii::Tensor<1, 3>({voxel, voxel, voxel});
    grid.origin = dealii::Point<3>(-half_width, -90., -half_width);
    grid.size = {std::size_t(2. * half_width / voxel) + 1, 34,
                 std::size_t(2. * half_width / voxel) + 1};
    image::LabelImage result(grid);
    for (std::size_t v = 0; v < result.values.size(); ++v)
      result.values[v] = label(position(grid, v));
    return result;
  }

  static dealii::Point<3> position(const image::VoxelGrid& grid, std::size_t v) {
    return grid.physical(double(v % grid.size[0]), double(v / grid.size[0] % grid.size[1]),
                         double(v / grid.size[0] / grid.size[1]));
  }
};

/// An image of labels: intensities of air, chest, fat and gland, with a texture that is fixed in
/// space and has no symmetry.
inline image::ScalarImage image_of(const image::LabelImage& labels, float fat = 0.9f,
                                   float gland = 0.2f) {
  image::ScalarImage result(labels.grid);
  for (std::size_t v = 0; v < result.values.size(); ++v) {
    const dealii::Point<3> x = HalfEllipsoid::position(labels.grid, v);
    const std::uint8_t label = labels.values[v];
    const float mean = label == 2 ? fat : label == 3 ? gland : label == 1 ? 0.5f : 0.f;
    const double texture = std::sin(0.11 * x[0] + 1.) * std::cos(0.07 * x[2] + 0.05 * x[0]) +
                           0.5 * std::sin(0.13 * x[2] - 0.4);
    result.values[v] = mean + (label == 0 ? 0.f : 0.06f * float(texture));
  }
  return result;
}

/// Both breasts as a reader leaves them.
inline registration::Inputs inputs_of(const image::LabelImage& prone,
                                      const image::LabelImage& supine) {
  registration::Inputs inputs;
  inputs.scene.labels = {prone, supine};
  for (const Position position : both_positions) {
    const image::LabelImage& labels = inputs.scene.labels[position];
    inputs.images[position] = image_of(labels);
    inputs.originals[position].image = inputs.images[position];
    inputs.originals[position].breast = labels;
    for (std::uint8_t& value : inputs.originals[position].breast.values)
      value = value == 2 || value == 3;
  }
  return inputs;
}

} // namespace prosup::tests

#endif
