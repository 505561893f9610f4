#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "all_laws.h"
#include "mechanics/element/element_kernel.h"

namespace prosup::tests {
namespace {

using namespace prosup::mechanics::kernel;
using prosup::mechanics::Law;

// Eight elements of ten nodes each, near to a unit element, in aligned memory.
template <typename Real>
struct EightElements {
  alignas(64) double reference[node_stride * 10 * n_lanes] = {};
  alignas(64) double positions[node_stride * 10 * n_lanes] = {};
  LinearBatch<Real> linear;
  QuadraticBatch<Real> quadratic;
  BatchMaterial<Real> material;

  EightElements() {
    const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
    for (int lane = 0; lane < n_lanes; ++lane) {
      material.mu[lane] = Real(300 + 10 * lane);
      material.lambda[lane] = Real(2000 - 30 * lane);
      for (int a = 0; a < 10; ++a) {
        const unsigned node = 10 * lane + a;
        quadratic.node[a][lane] = node;
        if (a < 4)
          linear.node[a][lane] = node;
        for (int c = 0; c < 3; ++c) {
          const double X = a < 4
                               ? corners[a][c]
                               : 0.5 * (corners[edges[a - 4][0]][c] + corners[edges[a - 4][1]][c]);
          reference[node_stride * node + c] = 6. * X + 0.3 * std::sin(1.3 * node + 2. * c);
          positions[node_stride * node + c] =
              reference[node_stride * node + c] + 0.2 * std::cos(0.7 * node + c);
        }
        positions[node_stride * node + 3] = 10. * std::sin(node); // a nodal pressure
      }
    }
  }

  /// All that the kernels of one set compute.
  std::vector<double> results(const Kernels<Real>& kernels) {
    std::vector<double> all;
    const auto add = [&](auto kernel, const auto& law, const auto& batch) {
      alignas(64) double force[node_stride * 10 * n_lanes] = {};
      all.push_back(kernel(law, &batch, 0, 1, Materials<Real>{&material, 1}, positions, force));
      all.insert(all.end(), std::begin(force), std::end(force));
    };
    all.push_back(kernels.set_linear_reference(&linear, 0, 1, reference));
    all.push_back(kernels.set_quadratic_reference(&quadratic, 0, 1, reference));
    for (const Law& choice : all_laws())
      std::visit(
          [&](const auto& law) {
            add(kernels.of(law).add_linear, law, linear);
            add(kernels.of(law).add_nodal_pressure, law, linear);
            add(kernels.of(law).add_quadratic, law, quadratic);
          },
          choice);
    double volumes[10 * n_lanes] = {};
    kernels.add_nodal_volumes(&linear, 0, 1, positions, volumes);
    all.insert(all.end(), std::begin(volumes), std::end(volumes));
    return all;
  }
};

template <typename Real>
void expect_all_sets_agree(double tolerance) {
  int n = 0;
  const Kernels<Real>* const* sets = all_kernels<Real>(n);
  ASSERT_GE(n, 1);
  EightElements<Real> elements;
  const std::vector<double> plain = elements.results(*sets[0]);
  double scale = 0.;
  for (const double value : plain)
    scale = std::max(scale, std::abs(value));
  EXPECT_GT(scale, 100.);
  for (int i = 1; i < n; ++i) {
    const std::vector<double> found = elements.results(*sets[i]);
    for (std::size_t k = 0; k < plain.size(); ++k)
      EXPECT_NEAR(found[k], plain[k], tolerance * scale) << sets[i]->instruction_set << " " << k;
  }
}

TEST(InstructionSets, AgreeInDoublePrecision) {
  expect_all_sets_agree<double>(1e-13);
}

TEST(InstructionSets, AgreeInSinglePrecision) {
  expect_all_sets_agree<float>(1e-5);
}

} // namespace
} // namespace prosup::tests
