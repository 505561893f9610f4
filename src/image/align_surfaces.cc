#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "prosup/core/error.h"
#include "prosup/core/quantile.h"
#include "prosup/image/rigid_alignment.h"
#include "prosup/image/sampling.h"

namespace prosup::image {

using namespace dealii;

namespace {

constexpr std::size_t n_points_wanted = 20000; // of each surface
constexpr std::size_t n_points_needed = 200;   // that both images show
constexpr unsigned n_steps = 30;
constexpr double settled = 1e-3;      // mm: a step that is the last one
constexpr double smallest_scale = 1.; // mm, of the weights: the stairs of a mask
constexpr double lever = 50.;         // mm, that makes rotations comparable with translations
// A direction of which the surfaces know less than this part of what they know
// of the best one is taken as undetermined.
constexpr double least_known = 0.03;

using Motion = std::array<double, 6>; // rotation vector times lever, translation; mm

/// Where the distance passes zero between neighbours, at most n_points_wanted.
std::vector<Point<3>> zero_crossings(const ScalarImage& distance) {
  const VoxelGrid& grid = distance.grid;
  std::vector<Point<3>> points;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i) {
        const double here = distance(i, j, k);
        const std::array<std::size_t, 3> index{i, j, k};
        for (unsigned d = 0; d < 3; ++d) {
          if (index[d] + 1 == grid.size[d])
            continue;
          const double next = distance(i + (d == 0), j + (d == 1), k + (d == 2));
          if ((here < 0.) == (next < 0.))
            continue;
          std::array<double, 3> at{double(i), double(j), double(k)};
          at[d] += here / (here - next);
          points.push_back(grid.physical(at[0], at[1], at[2]));
        }
      }
  const std::size_t stride = points.size() / n_points_wanted + 1;
  std::vector<Point<3>> chosen;
  for (std::size_t p = 0; p < points.size(); p += stride)
    chosen.push_back(points[p]);
  return chosen;
}

/// A distance r and how it changes with the motion of the source.
struct Residual {
  double r;
  Motion slope;
};

class SurfacePair {
public:
  SurfacePair(const ScalarImage& target, const ScalarImage& source)
      : target_(target), source_(source), target_points_(zero_crossings(target)),
        source_points_(zero_crossings(source)) {
    for (const Point<3>& p : target_points_)
      centre_ += (p - Point<3>()) / double(target_points_.size());
  }

  const Point<3>& centre() const { return centre_; }

  std::vector<Residual> residuals(const RigidTransform& transform) const {
    std::vector<Residual> all;
    const RigidTransform inverse = transform.inverse();
    Tensor<1, 3> gradient;
    for (const Point<3>& p : source_points_) {
      const Point<3> x = transform(p);
      if (!target_.inside(x))
        continue;
      const double r = target_.value_and_gradient(x, gradient);
      all.push_back({r, slope(x, gradient)});
    }
    for (const Point<3>& x : target_points_) {
      const Point<3> p = inverse(x);
      if (!source_.inside(p))
        continue;
      const double r = source_.value_and_gradient(p, gradient);
      all.push_back({r, slope(x, -1. * (transform.rotation * gradient))});
    }
    return all;
  }

private:
  Motion slope(const Point<3>& x, const Tensor<1, 3>& gradient) const {
    const Tensor<1, 3> turning = cross_product_3d(x - centre_, gradient) / lever;
    return {turning[0], turning[1], turning[2], gradient[0], gradient[1], gradient[2]};
  }

  const BasicSampler<double> target_, source_;
  const std::vector<Point<3>> target_points_, source_points_;
  Point<3> centre_;
};

double median_distance(const std::vector<Residual>& residuals) {
  std::vector<double> distances;
  for (const Residual& residual : residuals)
    distances.push_back(std::abs(residual.r));
  return quantile(std::move(distances), 0.5);
}

RigidMotion as_motion(const Motion& m) {
  return {Tensor<1, 3>({m[0] / lever, m[1] / lever, m[2] / lever}),
          Tensor<1, 3>({m[3], m[4], m[5]})};
}

struct Step {
  RigidMotion motion;
  double length = 0.; // mm
  std::vector<RigidMotion> open;
};

/// The Gauss-Newton step in the directions that are determined.
Step best_step(const std::vector<Residual>& residuals, DegreesOfFreedom freedom) {
  const unsigned first = freedom == DegreesOfFreedom::translation ? 3 : 0, n = 6 - first;
  const double scale = std::max(smallest_scale, 2. * median_distance(residuals));
  LAPACKFullMatrix<double> normal(n, n);
  FullMatrix<double> vectors;
  Vector<double> right(n), values;
  normal = 0.;
  for (const Residual& residual : residuals) {
    const double weight = 1. / (1. + residual.r * residual.r / (scale * scale));
    for (unsigned a = 0; a < n; ++a) {
      right[a] -= weight * residual.r * residual.slope[first + a];
      for (unsigned b = 0; b < n; ++b)
        normal(a, b) += weight * residual.slope[first + a] * residual.slope[first + b];
    }
  }
  const double size = normal.frobenius_norm();
  normal.compute_eigenvalues_symmetric(-size, 2. * size, 1e-12 * size, values, vectors);
  const double largest = *std::max_element(values.begin(), values.end());
  Step step;
  for (unsigned e = 0; e < n; ++e) {
    Motion direction{};
    double along = 0.;
    for (unsigned a = 0; a < n; ++a) {
      direction[first + a] = vectors(a, e);
      along += vectors(a, e) * right[a] / values[e];
    }
    if (values[e] < least_known * largest) {
      step.open.push_back(as_motion(direction));
      continue;
    }
    step.motion.add(along, as_motion(direction));
    step.length = std::hypot(step.length, along);
  }
  return step;
}

} // namespace

SurfaceAlignment align_surfaces(const ScalarImage& target, const ScalarImage& source,
                                DegreesOfFreedom freedom, const RigidTransform& start) {
  const SurfacePair surfaces(target, source);
  SurfaceAlignment result;
  // The start, written about the centre of the surface.
  RigidTransform unmoved;
  unmoved.centre = start.inverse()(surfaces.centre());
  result.transform = compose(start, unmoved);
  for (unsigned s = 0; s <= n_steps; ++s) {
    const std::vector<Residual> residuals = surfaces.residuals(result.transform);
    result.n_points = residuals.size();
    if (result.n_points < n_points_needed)
      throw Error(
          "The chest walls of the two images have no surface in common, so that they cannot be "
          "aligned; check that both label images mark the same side of the chest in roughly one "
          "coordinate system, or set 'Pre-alignment/Method' to none.");
    result.distance_after = median_distance(residuals);
    if (s == 0)
      result.distance_before = result.distance_after;
    Step step = best_step(residuals, freedom);
    result.open = std::move(step.open);
    if (step.length < settled || s == n_steps)
      break;
    result.transform = compose(step.motion.about(surfaces.centre()), result.transform);
  }
  return result;
}

} // namespace prosup::image
