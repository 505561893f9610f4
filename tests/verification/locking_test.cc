#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "figures.h"
#include "static_box.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

constexpr double edge = 60., mu = 400.; // mm, Pa

/// How far the lowest node of a hanging cube sinks, mm.
double sag(ElementType type, double nu, unsigned n) {
  StaticBox cube({n, n, n}, {edge, edge, edge}, type, lame_parameters(mu, nu), "petsc-direct");
  cube.parameters.load_steps = nu > 0.496 ? 2 : 1;
  EXPECT_TRUE(cube.load().converged);
  double deepest = 0.;
  for (unsigned node = 0; node < cube.body.n_owned_nodes(); ++node)
    deepest = std::max(deepest, -node_value(cube.displacement, node)[1]);
  deepest = Utilities::MPI::max(deepest, MPI_COMM_WORLD);
  return deepest;
}

/// The sag that quadratic elements tend to: a + b/n^2 through that of 6 and of 8
/// bricks per edge (with 4 it errs by 0.02 mm), which take minutes to find.
double converged_sag(double nu) {
  static const std::map<double, double> sags{
      {0.45, 18.31}, {0.49, 17.33}, {0.495, 17.21}, {0.499, 17.11}};
  return sags.at(nu);
}

struct Mesh {
  ElementType type;
  unsigned n;       ///< bricks of five tetrahedra per edge: all have 729 nodes
  double least_sag; ///< allowed at nu = 0.499, relative
  double most_sag;
};

// What linear elements do is written down, too: they lock.
TEST(Locking, SagOfANearlyIncompressibleCube) {
  for (const Mesh& mesh :
       {Mesh{ElementType::linear, 8, 0.65, 0.75}, Mesh{ElementType::nodal_pressure, 8, 0.84, 1.},
        Mesh{ElementType::quadratic, 4, 0.95, 1.}}) {
    std::string list;
    double relative = 0.;
    for (const double nu : {0.45, 0.49, 0.495, 0.499}) {
      relative = sag(mesh.type, nu, mesh.n) / converged_sag(nu);
      list += format("%s%.1f", list.empty() ? "" : ", ", 100. * (relative - 1.));
    }
    EXPECT_GT(relative, mesh.least_sag) << name_of(mesh.type);
    EXPECT_LT(relative, mesh.most_sag) << name_of(mesh.type);
    tell_figure("sag of a hanging cube at nu = 0.45, 0.49, 0.495, 0.499, " + name_of(mesh.type) +
                    ", 729 nodes",
                "fine quadratic mesh, extrapolated", list + " %",
                format("at 0.499: %.0f to %.0f %%", 100. * (mesh.least_sag - 1.),
                       100. * (mesh.most_sag - 1.)));
  }
}

// Run by hand; gives the numbers of converged_sag().
TEST(Locking, DISABLED_ConvergedSag) {
  for (const double nu : {0.45, 0.49, 0.495, 0.499}) {
    const double coarse = sag(ElementType::quadratic, nu, 6),
                 fine = sag(ElementType::quadratic, nu, 8);
    EXPECT_NEAR(fine + (fine - coarse) * 36. / (64. - 36.), converged_sag(nu), 0.01);
  }
}

} // namespace
} // namespace prosup::tests
