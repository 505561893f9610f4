// Nodes that jump to and fro on a ridge of the chest while all others have settled.

#include <gtest/gtest.h>

#include <cmath>

#include "loaded_box.h"
#include "prosup/mechanics/laws/material.h"
#include "prosup/unloading/unloading.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using unloading::Unloading;

constexpr double edge = 60.;
const Tensor<1, 3> down({0., -1., 0.});

/// A level chest above the tissue, with a short sharp ridge across the middle of it. The normal
/// jumps on the ridge, as it does where the distance to a chest has no gradient.
class Ridge : public mechanics::Surface {
public:
  double distance(const Tensor<1, 3>& x, Tensor<1, 3>& normal) const override {
    constexpr double slope = 1.5, half_width = 6.;
    const double off = x[0] - 0.5 * edge, along = x[2] - 0.5 * edge;
    normal = down;
    double height = 0.;
    if (std::abs(off) < half_width && std::abs(along) < half_width) {
      height = slope * (half_width - std::abs(off));
      normal[0] = std::copysign(slope, off);
      normal /= normal.norm();
    }
    return (edge - x[1] - height) / std::sqrt(1. + slope * slope);
  }
};

TEST(StalledNodes, AreHeldAndNamed) {
  const auto mesh = make_box(MPI_COMM_WORLD, {8, 8, 8}, {edge, edge, edge});
  const mechanics::Body body(*mesh);
  HangingBoxParameters parameters;
  mechanics::Supports supports(body);
  supports.slide_on(std::make_shared<Ridge>(), {3}, mechanics::ContactLaw::tied);
  supports.add_springs({3}, 8.);
  // Gravity that pulls the node over the ridge.
  Unloading unloading(parameters, supports, Tensor<1, 3>({0.1, -1., 0.}), "the box");
  unloading.set_material({mechanics::lame_parameters(500., 0.4)});
  const settling::SettlingResult result = unloading.run();
  EXPECT_TRUE(result.converged) << result.explanation;
  ASSERT_EQ(unloading.remarks().size(), 1u) << result.n_retries << " retries, " << result.n_steps;
  EXPECT_NE(unloading.remarks()[0].find("of 81 nodes"), std::string::npos)
      << unloading.remarks()[0];
}

} // namespace
} // namespace prosup::tests
