#ifndef PROSUP_TESTS_WARPED_PAIRS_H
#define PROSUP_TESTS_WARPED_PAIRS_H

#include <cmath>
#include <functional>
#include <random>

#include "prosup/similarity/metric.h"

namespace prosup::tests {

using dealii::Point;
using similarity::VoxelDerivatives;
using similarity::WarpedPair;

/// Fat and gland with soft borders, bright blobs of some 12 mm on dark ground
/// with a little texture: 0.1 to 0.9.
inline double blobs(const Point<3>& x) {
  const double wave = std::sin(0.26 * x[0] + 0.4) + std::sin(0.22 * x[1] + 0.05 * x[0]) +
                      std::cos(0.24 * x[2] - 0.03 * x[1]);
  return 0.5 + 0.35 * std::tanh(2. * wave) + 0.05 * std::sin(0.9 * x[0] + 0.7 * x[1]);
}

using Intensity = std::function<double(const Point<3>&)>;

/// Both images sampled on a grid of 24 x 26 x 22 voxels of 2 mm, with noise. The
/// domain is a ball that one side of the grid cuts.
inline WarpedPair warped_pair(const Intensity& prone, const Intensity& supine, double noise = 0.) {
  WarpedPair pair;
  pair.grid.size = {24, 26, 22};
  pair.grid.spacing = dealii::Tensor<1, 3>({2., 2., 2.});
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (std::size_t k = 0; k < 22; ++k)
    for (std::size_t j = 0; j < 26; ++j)
      for (std::size_t i = 0; i < 24; ++i) {
        const Point<3> x = pair.grid.physical(double(i), double(j), double(k));
        pair.values.prone.push_back(static_cast<float>(prone(x) + noise * normal(random)));
        pair.values.supine.push_back(static_cast<float>(supine(x) + noise * normal(random)));
        pair.in_domain.push_back(x.distance(Point<3>(22., 30., 20.)) < 23.);
      }
  return pair;
}

/// One of the images with `step` times `direction` added.
inline WarpedPair moved(WarpedPair pair, Position position, const std::vector<float>& direction,
                        double step) {
  for (std::size_t v = 0; v < direction.size(); ++v)
    pair.values[position][v] += static_cast<float>(step * direction[v]);
  return pair;
}

inline std::vector<float> random_direction(std::size_t n) {
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  std::vector<float> direction(n);
  for (float& d : direction)
    d = normal(random);
  return direction;
}

} // namespace prosup::tests

#endif
