#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "figures.h"
#include "static_box.h"

using namespace dealii;
using namespace prosup;
using namespace prosup::mechanics;
using tests::tell_figure;

namespace {

constexpr double edge = 60., mu = 400.; // mm, Pa

/// How far the lowest node of a hanging cube sinks, mm.
double sag(ElementType type, double nu, unsigned n) {
  tests::StaticBox cube({n, n, n}, {edge, edge, edge}, type, lame_parameters(mu, nu),
                        "petsc-direct");
  cube.parameters.load_steps = nu > 0.496 ? 2 : 1;
  const QuasiStaticResult result = cube.load();
  double deepest = 0.;
  for (unsigned node = 0; node < cube.body.n_owned_nodes(); ++node)
    deepest = std::max(deepest, -node_value(cube.displacement, node)[1]);
  deepest = Utilities::MPI::max(deepest, MPI_COMM_WORLD);
  printf("%s nu %g n %u: %u load %u newton %u linear, sag %.5f minJ %.3f\n",
         tests::name_of(type).c_str(), nu, n, result.n_load_steps, result.n_newton_steps,
         result.n_linear_iterations, deepest, result.min_jacobian);
  fflush(stdout);
  return deepest;
}

} // namespace

TEST(Locking, Explore) {
  for (const double nu : {0.45, 0.49, 0.495, 0.499})
    for (const ElementType type : tests::all_element_types)
      for (unsigned n : {4u, 8u}) {
        if (type == ElementType::quadratic && n == 8)
          continue;
        sag(type, nu, n);
      }
}

TEST(Locking, DISABLED_Fine) {
  for (unsigned n : {6, 8, 10, 12})
    for (const double nu : {0.45, 0.49, 0.495, 0.499})
      sag(ElementType::quadratic, nu, n);
  for (unsigned n : {12, 16})
    for (const double nu : {0.45, 0.49, 0.495, 0.499})
      sag(ElementType::nodal_pressure, nu, n);
}
