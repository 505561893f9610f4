#ifndef PROSUP_BENCHMARKS_STABILITY_MAP_BREAST_H
#define PROSUP_BENCHMARKS_STABILITY_MAP_BREAST_H

#include <deal.II/grid/tria.h>

#include <vector>

#include "prosup/mechanics/static/quasi_static.h"

namespace prosup::benchmarks {

/// The density of tissue and the acceleration of gravity: rho g, g/(mm^2 s^2).
constexpr double specific_weight = 9.81;
constexpr double breast_depth = 60.; ///< L, mm
constexpr double breast_poisson_ratio = 0.45;

/// Half a ball of depth L, imaged loaded, held at its flat base (boundary id 1)
/// with gravity away from the base (prone) or towards it (supine), and its
/// unloaded configuration by Newton's method.
class HalfBall {
public:
  /// A larger `softness` rho g L/mu moves more; `n_refinements` halvings of the
  /// edges of 144 tetrahedra.
  HalfBall(double softness, bool prone, unsigned n_refinements);

  mechanics::Body body;
  const dealii::Tensor<1, 3> gravity; ///< unit vector
  const mechanics::Material material;
  const std::vector<bool> fixed;
  bool has_solution = false;
  mechanics::NodeVector unloaded; ///< X of Newton's solution
  double motion = 0.;             ///< max |x - X|, mm
};

double max_distance(const mechanics::NodeVector& a, const mechanics::NodeVector& b);

} // namespace prosup::benchmarks

#endif
