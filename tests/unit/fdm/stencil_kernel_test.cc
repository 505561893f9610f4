#include "fdm/stencil_kernel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <deal.II/base/tensor.h>

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::fdm::kernel;

/// A problem that is known everywhere: u_k,I, mu and lambda as functions of X.
struct Problem {
  std::function<Tensor<1, 3>(const Tensor<1, 3>&)> u;
  std::function<Tensor<2, 3>(const Tensor<1, 3>&)> gradient;
  std::function<double(const Tensor<1, 3>&)> mu, lambda;

  /// P of the neo-Hookean law (the transpose of the paper's eq. 2).
  Tensor<2, 3> stress(const Tensor<1, 3>& X) const {
    Tensor<2, 3> F = gradient(X);
    for (unsigned d = 0; d < 3; ++d)
      F[d][d] += 1.;
    const Tensor<2, 3> inverse_transposed = transpose(invert(F));
    return mu(X) * (F - inverse_transposed) +
           lambda(X) * std::log(determinant(F)) * inverse_transposed;
  }

  /// d_I P_jI by differences of sixth order with a step that leaves errors of 1e-8.
  Tensor<1, 3> divergence(const Tensor<1, 3>& X) const {
    constexpr double h = 0.02;
    constexpr double weights[3] = {45. / 60., -9. / 60., 1. / 60.};
    Tensor<1, 3> result;
    for (unsigned I = 0; I < 3; ++I)
      for (int n = 1; n <= 3; ++n) {
        Tensor<1, 3> step;
        step[I] = n * h;
        const Tensor<2, 3> difference = stress(X + step) - stress(X - step);
        for (unsigned j = 0; j < 3; ++j)
          result[j] += weights[n - 1] / h * difference[j][I];
      }
    return result;
  }
};

/// Forces per mass that one step of a kernel gives at the centre of a grid of
/// 7 x 5 x 5 nodes around `centre`: increments of a step of 1 s from rest.
template <typename Real>
Tensor<1, 3> force_at(const Kernels& kernels, const Problem& problem, const Tensor<1, 3>& centre,
                      double spacing) {
  constexpr int nx = 7, ny = 5, nz = 5;
  constexpr std::size_t n = nx * ny * nz, middle = n / 2;
  std::array<std::vector<Real>, 12> fields;
  for (auto& field : fields)
    field.assign(n, Real(0));
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const std::size_t node = i + nx * (j + ny * k);
        const Tensor<1, 3> X = centre + spacing * Tensor<1, 3>({i - 3., j - 2., k - 2.});
        const Tensor<1, 3> u = problem.u(X);
        for (unsigned c = 0; c < 3; ++c)
          fields[c][node] = Real(u[c]);
        fields[3][node] = Real(problem.mu(X));
        fields[4][node] = Real(problem.lambda(X));
        fields[5][node] = Real(1);
      }
  Fields<Real> arguments{};
  for (unsigned c = 0; c < 3; ++c) {
    arguments.u[c] = fields[c].data();
    arguments.f[c] = fields[6 + c].data();
    arguments.increment[c] = fields[9 + c].data();
  }
  arguments.mu = fields[3].data();
  arguments.lambda = fields[4].data();
  arguments.mobility = fields[5].data();
  arguments.row = nx;
  arguments.plane = nx * ny;
  arguments.spacing = Real(spacing);
  arguments.inverse_density = Real(1);
  arguments.squared_step = Real(1);
  kernels.step(Real())(arguments, middle, middle + 1);
  return Tensor<1, 3>({fields[9][middle], fields[10][middle], fields[11][middle]});
}

Problem waves() {
  Problem problem;
  problem.u = [](const Tensor<1, 3>& X) {
    return Tensor<1, 3>({0.5 * std::sin(0.4 * X[1] + 0.3 * X[2]) + 0.1 * X[0],
                         0.4 * std::cos(0.3 * X[0]) * std::sin(0.5 * X[2]),
                         0.3 * std::sin(0.4 * X[0] - 0.2 * X[1] + 0.3 * X[2])});
  };
  problem.gradient = [](const Tensor<1, 3>& X) {
    Tensor<2, 3> D;
    const double a = 0.5 * std::cos(0.4 * X[1] + 0.3 * X[2]);
    const double b = 0.3 * std::cos(0.4 * X[0] - 0.2 * X[1] + 0.3 * X[2]);
    D[0] = Tensor<1, 3>({0.1, 0.4 * a, 0.3 * a});
    D[1] = Tensor<1, 3>({-0.12 * std::sin(0.3 * X[0]) * std::sin(0.5 * X[2]), 0.,
                         0.2 * std::cos(0.3 * X[0]) * std::cos(0.5 * X[2])});
    D[2] = Tensor<1, 3>({0.4 * b, -0.2 * b, 0.3 * b});
    return D;
  };
  problem.mu = [](const Tensor<1, 3>& X) { return 2. + std::sin(0.5 * X[0] + 0.2 * X[1]); };
  problem.lambda = [](const Tensor<1, 3>& X) {
    return 10. + 4. * std::cos(0.3 * X[1] - 0.4 * X[2]);
  };
  return problem;
}

const std::vector<Tensor<1, 3>> places{Tensor<1, 3>({0.3, -0.7, 1.1}),
                                       Tensor<1, 3>({2., 1., -1.5})};

TEST(StencilKernel, AffineDisplacementGivesNoForce) {
  Problem problem;
  problem.u = [](const Tensor<1, 3>& X) {
    return Tensor<1, 3>({0.2 * X[0] + 0.3 * X[1], -0.1 * X[2], 0.25 * X[1] - 0.2 * X[2]});
  };
  problem.mu = [](const Tensor<1, 3>&) { return 3.; };
  problem.lambda = [](const Tensor<1, 3>&) { return 20.; };
  int n_kernels = 0;
  const auto kernels = all_kernels(n_kernels);
  for (int i = 0; i < n_kernels; ++i)
    EXPECT_LT(force_at<double>(*kernels[i], problem, places[0], 0.5).norm(), 1e-11)
        << kernels[i]->instruction_set;
}

TEST(StencilKernel, MeetsTheDivergenceOfTheStressToSecondOrder) {
  const Problem problem = waves();
  int n_kernels = 0;
  const auto kernels = all_kernels(n_kernels);
  for (int i = 0; i < n_kernels; ++i)
    for (const Tensor<1, 3>& X : places) {
      const Tensor<1, 3> exact = problem.divergence(X);
      const double coarse = (force_at<double>(*kernels[i], problem, X, 0.2) - exact).norm();
      const double fine = (force_at<double>(*kernels[i], problem, X, 0.1) - exact).norm();
      EXPECT_LT(fine, 0.01 * exact.norm()) << kernels[i]->instruction_set;
      EXPECT_NEAR(coarse / fine, 4., 0.2) << kernels[i]->instruction_set;
    }
}

TEST(StencilKernel, AllInstructionSetsAndPrecisionsAgree) {
  const Problem problem = waves();
  int n_kernels = 0;
  const auto kernels = all_kernels(n_kernels);
  const Tensor<1, 3> first = force_at<double>(*kernels[0], problem, places[0], 0.5);
  for (int i = 0; i < n_kernels; ++i) {
    EXPECT_LT((force_at<double>(*kernels[i], problem, places[0], 0.5) - first).norm(),
              1e-12 * first.norm());
    EXPECT_LT((force_at<float>(*kernels[i], problem, places[0], 0.5) - first).norm(),
              1e-4 * first.norm());
  }
}

} // namespace
} // namespace prosup::tests
