#include <gtest/gtest.h>

#include <cmath>

#include "figures.h"
#include "loaded_box.h"
#include "static_box.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

constexpr double length = 100.; // mm
const std::vector<unsigned> n_bricks{1, 25, 1};
const Point<3> size(4., length, 4.);

/// How far the end of the column sinks, mm. nu = 0: it hangs in one dimension,
/// P = mu (F - 1/F) = w s at the distance s from the free end, hence
/// F = q + sqrt(q^2 + 1) with q = w s / (2 mu), integrated over the length.
double exact_sag(double mu, double weight) {
  const double a = weight * length / (2. * mu);
  return length * (0.5 * a + 0.5 * std::sqrt(a * a + 1.) + 0.5 * std::asinh(a) / a - 1.);
}

double lowest(const Body& body, const NodeVector& displacement) {
  double least = 0.;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    least = std::min(least, node_value(displacement, node)[1]);
  return -Utilities::MPI::min(least, MPI_COMM_WORLD);
}

double newton_sag(double mu) {
  StaticBox column(n_bricks, size, ElementType::quadratic, lame_parameters(mu, 0.));
  EXPECT_TRUE(column.load().converged);
  return lowest(column.body, column.displacement);
}

double explicit_sag(double mu) {
  const auto mesh = make_box(MPI_COMM_WORLD, n_bricks, size);
  const Body body(*mesh, Element{ElementType::quadratic});
  const HangingBoxParameters parameters;
  Supports supports(body, {3});
  unloading::Unloading loading(parameters, supports, Tensor<1, 3>({0., -1., 0.}));
  loading.hold_reference();
  loading.set_material({lame_parameters(mu, 0.)});
  EXPECT_TRUE(loading.run().converged);
  return lowest(body, loading.displacement());
}

void expect_sags(const std::string& solver, double (*sag)(double)) {
  constexpr double bound = 0.001; // mm
  double largest = 0., deepest = 0.;
  for (const double mu : {2500., 1000., 470.}) {
    const double exact = exact_sag(mu, 9.81);
    deepest = std::max(deepest, exact);
    largest = std::max(largest, std::abs(sag(mu) - exact));
  }
  EXPECT_GT(deepest, 50.);
  EXPECT_LT(largest, bound);
  tell_figure("hanging column, nu = 0, quadratic, " + solver +
                  format(", sag up to %.1f mm", deepest),
              "exact sag", format("%.1e mm", largest), format("%.3f mm", bound));
}

TEST(HangingColumn, NewtonAgainstTheExactSag) {
  expect_sags("Newton", newton_sag);
}

TEST(HangingColumn, ExplicitAgainstTheExactSag) {
  expect_sags("explicit", explicit_sag);
}

} // namespace
} // namespace prosup::tests
