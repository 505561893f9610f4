#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <gtest/gtest.h>

#include <cmath>

#include "figures.h"
#include "moving_box.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

/// Largest omega^2 of K phi = omega^2 M phi on the free nodes by LAPACK's dsygv,
/// K column by column from differences of forces. For bodies of one rank.
double dense_eigenvalue(const MovingBox& box, const std::vector<double>& mass) {
  std::vector<unsigned> free;
  for (unsigned i = 0; i < 3 * box.body.n_owned_nodes(); ++i)
    if (!box.supports.fixed()[i / 3])
      free.push_back(i);
  const unsigned n = free.size();
  FullMatrix<double> differences(n);
  constexpr double step = 1e-4; // mm
  for (unsigned j = 0; j < n; ++j)
    for (const double sign : {-1., 1.}) {
      NodeVector u = box.displacement, f;
      box.body.initialize(f);
      u.zero_out_ghost_values();
      u.local_element(free[j]) += sign * step;
      box.forces.subtract(u, f);
      for (unsigned i = 0; i < n; ++i)
        differences(i, j) -= sign * f.local_element(free[i]) / (2. * step);
    }
  LAPACKFullMatrix<double> K(n), M(n);
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) {
      K(i, j) = 0.5 * (differences(i, j) + differences(j, i));
      M(i, j) = i == j ? mass[free[i] / 3] : 0.;
    }
  std::vector<Vector<double>> eigenvectors;
  K.compute_generalized_eigenvalues_symmetric(M, eigenvectors);
  double largest = 0.;
  for (unsigned i = 0; i < n; ++i)
    largest = std::max(largest, K.eigenvalue(i).real());
  return largest;
}

struct Shape {
  const char* name;
  Distortion distortion;
};

/// A state in which the box is bent, stretched and compressed by a third.
void bend(MovingBox& box) {
  for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node) {
    const Tensor<1, 3> X = node_value(box.body.vertex_positions(), node);
    box.displacement.local_element(3 * node) = -0.01 * X[0] * X[2];
    box.displacement.local_element(3 * node + 1) = 0.3 * (25. - X[1]);
    box.displacement.local_element(3 * node + 2) = 0.1 * X[1];
  }
  box.displacement.update_ghost_values();
}

/// Reported critical step over the true limit: smallest and largest over element
/// types, with and without scaled masses, at rest and deformed.
std::pair<double, double> step_ratios(const Shape& shape, ElementType type) {
  std::pair<double, double> range{1e30, 0.};
  const std::vector<unsigned> n = type == ElementType::quadratic ? std::vector<unsigned>{3, 1, 1}
                                                                 : std::vector<unsigned>{3, 2, 2};
  for (const double nu : {0.3, 0.49})
    for (const bool bent : {false, true})
      for (const double scaled : {0., 0.5, 1.}) {
        MovingBox box(n, type, nu, shape.distortion, MPI_COMM_SELF);
        if (bent)
          bend(box);
        const StableMass mass = box.mass(scaled);
        const double limit = 2. / std::sqrt(dense_eigenvalue(box, mass.mass));
        range.first = std::min(range.first, mass.critical_step / limit);
        range.second = std::max(range.second, mass.critical_step / limit);
      }
  return range;
}

TEST(HighestFrequency, CriticalStepAgainstADenseEigenvalueProblem) {
  const std::vector<Shape> shapes{
      {"regular", nullptr}, {"distorted", jittered}, {"slivers", flattened}};
  for (const ElementType type : all_element_types)
    for (const Shape& shape : shapes) {
      const auto [least, most] = step_ratios(shape, type);
      EXPECT_GT(least, 0.9) << name_of(type) << " " << shape.name;
      EXPECT_LE(most, 1. + 1e-6) << name_of(type) << " " << shape.name;
      tell_figure(std::string("critical step, ") + shape.name + ", " + name_of(type) +
                      ", nu 0.3 and 0.49, rest and bent, masses scaled or not",
                  "all of K phi = omega^2 M phi by LAPACK",
                  format("%.3f to %.3f of the true limit", least, most), "0.9 to 1");
    }
}

} // namespace
} // namespace prosup::tests
