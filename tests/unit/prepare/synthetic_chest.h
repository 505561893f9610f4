#ifndef PROSUP_TESTS_UNIT_PREPARE_SYNTHETIC_CHEST_H
#define PROSUP_TESTS_UNIT_PREPARE_SYNTHETIC_CHEST_H

#include <cmath>
#include <random>

#include "prosup/image/voxel_image.h"

namespace prosup::tests {

/// Intensities of a synthetic scan.
struct SyntheticContrast {
  double air = 4., fat = 200., gland = 80., muscle = 60., lung = 10., noise = 4.;
};

inline SyntheticContrast suppressed_fat() {
  return {4., 60., 150., 110., 12., 4.};
}

inline SyntheticContrast hounsfield() {
  return {-1000., -100., 40., 50., -800., 10.};
}

/// A chest with two breasts, whose surfaces are known: a cylinder of muscle of radius 100 mm about
/// x = 0, y = 130 with a lung in it, 20 mm of fat in front, and two half ellipsoids of fat with a
/// ball of gland in each, at y = -5 or where it is told. It ends 60 mm behind the front of the
/// chest, within the lung. Small and of coarse voxels, since many tests go through it.
struct SyntheticChest {
  static constexpr double chest_radius = 100., skin_radius = 120., lung_radius = 82.;
  static constexpr double axis_y = 130., breast_x = 60., gland_radius = 22.;

  double gland_y;
  image::ScalarImage image;
  image::LabelImage labels; ///< 0 air, 1 chest, 2 fat, 3 gland

  explicit SyntheticChest(const SyntheticContrast& contrast = {}, double bias = 0.,
                          double gland_y_ = -5.)
      : gland_y(gland_y_) {
    image::VoxelGrid grid;
    grid.size = {98, 61, 28};
    grid.spacing[0] = grid.spacing[1] = 2.5;
    grid.spacing[2] = 3.;
    grid.origin = image::Point<3>(-121.25, -60., -40.5);
    image = image::ScalarImage(grid);
    labels = image::LabelImage(grid);
    std::mt19937 generator(1);
    std::normal_distribution<double> noise(0., contrast.noise);
    for (std::size_t k = 0; k < grid.size[2]; ++k)
      for (std::size_t j = 0; j < grid.size[1]; ++j)
        for (std::size_t i = 0; i < grid.size[0]; ++i) {
          const image::Point<3> p = grid.physical(double(i), double(j), double(k));
          labels(i, j, k) = label(p);
          const double gain = std::exp(-bias * p[1] / 100.);
          image(i, j, k) = float(gain * blurred(p, contrast, grid) + noise(generator));
        }
  }

  /// Tissue in front of the chest without voxels that touch another kind.
  image::LabelImage inner() const {
    image::LabelImage mask(labels.grid);
    const auto& size = mask.grid.size;
    for (std::size_t k = 1; k + 1 < size[2]; ++k)
      for (std::size_t j = 1; j + 1 < size[1]; ++j)
        for (std::size_t i = 1; i + 1 < size[0]; ++i)
          mask(i, j, k) = labels(i, j, k) >= 2 && labels(i - 1, j, k) >= 2 &&
                          labels(i + 1, j, k) >= 2 && labels(i, j - 1, k) >= 2 &&
                          labels(i, j + 1, k) >= 2 && labels(i, j, k - 1) >= 2 &&
                          labels(i, j, k + 1) >= 2;
    return mask;
  }

  std::uint8_t label(const image::Point<3>& p) const {
    const double r = std::hypot(p[0], p[1] - axis_y);
    if (r < chest_radius)
      return 1;
    if (distance_to_gland(p) < gland_radius)
      return 3;
    return r < skin_radius || in_breast(p) ? 2 : 0;
  }

private:
  double distance_to_gland(const image::Point<3>& p) const {
    return std::sqrt(std::pow(std::abs(p[0]) - breast_x, 2) + std::pow(p[1] - gland_y, 2) +
                     p[2] * p[2]);
  }

  static bool in_breast(const image::Point<3>& p) {
    return std::pow((std::abs(p[0]) - breast_x) / 38., 2) + std::pow((p[1] - 30.) / 80., 2) +
               std::pow(p[2] / 32., 2) <
           1.;
  }

  double intensity(const image::Point<3>& p, const SyntheticContrast& contrast) const {
    switch (label(p)) {
    case 0:
      return contrast.air;
    case 1:
      return std::hypot(p[0], p[1] - axis_y) < lung_radius ? contrast.lung : contrast.muscle;
    case 2:
      return contrast.fat;
    default:
      return contrast.gland;
    }
  }

  /// The mean over a voxel.
  double blurred(const image::Point<3>& p, const SyntheticContrast& contrast,
                 const image::VoxelGrid& grid) const {
    double sum = 0.;
    for (const double dx : {-0.25, 0.25})
      for (const double dy : {-0.25, 0.25})
        for (const double dz : {-0.25, 0.25})
          sum += intensity({p[0] + dx * grid.spacing[0], p[1] + dy * grid.spacing[1],
                            p[2] + dz * grid.spacing[2]},
                           contrast);
    return sum / 8.;
  }
};

/// Overlap 2 |A and B| / (|A| + |B|) of the voxels where `chosen` is true.
template <typename Chosen>
double dice(const image::LabelImage& a, const image::LabelImage& b, const Chosen& chosen) {
  std::size_t both = 0, sum = 0;
  for (std::size_t v = 0; v < a.values.size(); ++v) {
    both += chosen(a.values[v]) && chosen(b.values[v]);
    sum += std::size_t(chosen(a.values[v])) + std::size_t(chosen(b.values[v]));
  }
  return 2. * double(both) / double(sum);
}

} // namespace prosup::tests

#endif
