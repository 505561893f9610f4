// Chests as masks of real breasts have them: with a sharp crest, as a thin sheath.

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "prosup/image/body_labels.h"
#include "prosup/mechanics/laws/material.h"
#include "prosup/mechanics/static/unloaded_response.h"
#include "prosup/mesh/distributed.h"
#include "prosup/mesh/mask_mesher.h"
#include "prosup/unloading/support_parameters.h"
#include "prosup/unloading/unloading.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using image::LabelImage;
using mechanics::node_value;
using unloading::ChestCondition;

const Tensor<1, 3> prone({0., -1., 0.});
constexpr double voxel = 2.;

/// Height of the chest above its base, towards the tissue (-y), mm.
using Relief = std::function<double(double x)>;

double flat(double) {
  return 0.;
}

/// As a thorax is, less steep to the left.
double curved(double x) {
  return -x * x / (x > 0. ? 150. : 100.);
}

/// A pectoral muscle that ends in a sharp edge.
double crest(double x) {
  return std::max(0., 14. - 3. * std::abs(x));
}

/// Half a ball of tissue that hangs from the chest; `thickness` is that of a sheath of muscle.
LabelImage breast(const Relief& relief, double thickness = 1000.) {
  image::VoxelGrid grid;
  grid.spacing = Tensor<1, 3>({voxel, voxel, voxel});
  grid.size = {56, 50, 56};
  grid.origin = Point<3>(-55., -71., -55.);
  LabelImage labels(grid);
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i) {
        const Point<3> x = grid.physical(double(i), double(j), double(k));
        const double behind = x[1] + relief(x[0]);
        if (behind > 0.)
          labels(i, j, k) = behind < thickness ? 1 : 0;
        else if (std::hypot(x[0], x[1], x[2]) < 45.)
          labels(i, j, k) = 2;
      }
  return labels;
}

double largest_difference(const mechanics::NodeVector& a, const mechanics::NodeVector& b) {
  double largest = 0.;
  for (unsigned i = 0; i < a.locally_owned_size(); ++i)
    largest = std::max(largest, std::abs(a.local_element(i) - b.local_element(i)));
  return Utilities::MPI::max(largest, MPI_COMM_WORLD);
}

class HungBreast {
public:
  explicit HungBreast(const LabelImage& labels)
      : labels_(image::with_inside_of_chest(labels, 1)),
        mesh_(mesh::make_distributed(mesher().mesh(labels_), MPI_COMM_WORLD)), body_(*mesh_) {}

  std::unique_ptr<mechanics::Supports> supports(ChestCondition chest) {
    return parameters_.make(chest, body_, labels_, {}, 1);
  }

  unsigned n_fixed() {
    const std::vector<bool> fixed = supports(ChestCondition::sliding)->fixed();
    return Utilities::MPI::sum(unsigned(std::count(fixed.begin(), fixed.end(), true)),
                               MPI_COMM_WORLD);
  }

  /// The unloaded positions.
  mechanics::NodeVector unload(ChestCondition chest, double bed, settling::SettlingResult& result,
                               const Tensor<1, 3>& gravity = prone) {
    const auto held = supports(chest);
    held->set_springs_on(chest_wall, bed);
    unloading::Unloading unloading(unloading_, *held, gravity);
    unloading.set_material({mechanics::lame_parameters(300., 0.4)});
    result = unloading.run();
    result.remarks = unloading.remarks();
    return unloading.unloaded();
  }

  /// Changes a settled breast a little and lets it settle again. Returns how far nodes have then
  /// moved, and how far from there mechanics::UnloadedResponse saw them, mm.
  using Change = std::function<void(mechanics::Supports&, unloading::Unloading&)>;
  std::array<double, 2> motion_and_error(const Change& change) {
    const auto held = supports(ChestCondition::sliding);
    held->set_springs_on(chest_wall, 4.);
    unloading_.residual_tolerance = 1e-5;
    unloading_.position_tolerance = 1e-4;
    unloading::Unloading unloading(unloading_, *held, prone);
    const mechanics::Material material({mechanics::lame_parameters(300., 0.45)});
    unloading.set_material(material);
    EXPECT_TRUE(unloading.run().converged);
    const mechanics::NodeVector before = unloading.unloaded();
    const mechanics::UnloadedResponse response(*held, material, unloading.body_force(), before);
    mechanics::NodeVector force = unloading.out_of_balance();
    force *= -1.;
    change(*held, unloading);
    force += unloading.out_of_balance();
    mechanics::NodeVector foreseen = before;
    foreseen += response.to(force, 1e-4);
    EXPECT_TRUE(unloading.run().converged);
    return {largest_difference(unloading.unloaded(), before),
            largest_difference(unloading.unloaded(), foreseen)};
  }

private:
  static constexpr auto chest_wall = types::boundary_id(mesh::BoundaryPart::chest_wall);

  const mesh::MaskMesher& mesher() {
    mesher_.edge_length = 9.;
    return mesher_;
  }

  Labels meaning_;
  mesh::MaskMesher mesher_{meaning_};
  unloading::SupportParameters parameters_;
  unloading::UnloadingParameters unloading_;
  LabelImage labels_;
  std::unique_ptr<parallel::fullydistributed::Triangulation<3>> mesh_;
  mechanics::Body body_;
};

TEST(RealChest, HoldsNothingWhereItIsSmooth) {
  EXPECT_EQ(HungBreast(breast(flat)).n_fixed(), 0u);
}

// The level sets of the distance go round the edge, where they have no normal.
TEST(RealChest, HoldsFacesWithoutANormal) {
  EXPECT_GT(HungBreast(breast(crest)).n_fixed(), 0u);
}

TEST(RealChest, LetsABreastSettleOnACrestAndOnASheath) {
  for (const LabelImage& labels : {breast(crest), breast(crest, 4.), breast(flat, 4.)}) {
    settling::SettlingResult result;
    HungBreast(labels).unload(ChestCondition::sliding, 8., result);
    EXPECT_TRUE(result.converged) << result.explanation;
    EXPECT_EQ(result.n_retries, 0u);
  }
}

// Nothing but the sheath is known of the chest, which has to be enough.
TEST(RealChest, IsTheSameBehindASheath) {
  settling::SettlingResult result;
  HungBreast full(breast(flat)), sheath(breast(flat, 4.));
  const auto X = full.unload(ChestCondition::sliding, 8., result);
  EXPECT_LT(largest_difference(X, sheath.unload(ChestCondition::sliding, 8., result)), 0.05);
}

// Without a bed it slides down a chest that is not level, and no state is at rest.
TEST(RealChest, IsHeldWhereABreastCannotSettleSliding) {
  const Tensor<1, 3> tilted({0.3, -1., 0.});
  settling::SettlingResult result, of_fixed;
  HungBreast breast_on_chest(breast(flat));
  const auto X = breast_on_chest.unload(ChestCondition::sliding, 0., result, tilted);
  EXPECT_TRUE(result.converged) << result.explanation;
  EXPECT_GT(result.n_retries, 0u);
  ASSERT_EQ(result.remarks.size(), 1u);
  EXPECT_NE(result.remarks[0].find("taken as fixed"), std::string::npos) << result.remarks[0];
  const auto fixed = breast_on_chest.unload(ChestCondition::fixed, 0., of_fixed, tilted);
  EXPECT_TRUE(of_fixed.remarks.empty());
  EXPECT_LT(largest_difference(X, fixed), 0.1);
}

TEST(RealChest, SlidingTendsToFixedAsTheBedStiffens) {
  settling::SettlingResult result;
  HungBreast breast_on_chest(breast(crest));
  const auto fixed = breast_on_chest.unload(ChestCondition::fixed, 0., result);
  double before = 0.;
  for (const double bed : {8., 800., 80000.}) {
    const double difference =
        largest_difference(fixed, breast_on_chest.unload(ChestCondition::sliding, bed, result));
    EXPECT_TRUE(result.converged);
    if (before > 0.) {
      EXPECT_LT(difference, 0.3 * before) << bed << " Pa/mm";
    }
    before = difference;
  }
  EXPECT_LT(before, 0.1);
}

// The derivatives of the search of properties. What is left over is of second order.
TEST(RealChest, UnloadedShapeFollowsMaterialBedAndGravity) {
  constexpr auto chest_wall = types::boundary_id(mesh::BoundaryPart::chest_wall);
  const std::vector<HungBreast::Change> changes{
      [](mechanics::Supports&, unloading::Unloading& unloading) {
        unloading.set_material({mechanics::lame_parameters(310., 0.452)});
      },
      [&](mechanics::Supports& supports, unloading::Unloading& unloading) {
        supports.set_springs_on(chest_wall, 4.2, 0.9);
        unloading.set_material({mechanics::lame_parameters(300., 0.45)}); // takes the springs over
      },
      [](mechanics::Supports&, unloading::Unloading& unloading) {
        unloading.set_gravity_direction(Tensor<1, 3>({0.02, -1., 0.01}));
      }};
  HungBreast breast_on_thorax(breast(curved));
  for (const HungBreast::Change& change : changes) {
    const auto [motion, error] = breast_on_thorax.motion_and_error(change);
    EXPECT_GT(motion, 0.05);
    EXPECT_LT(error, 0.06 * motion);
  }
}

} // namespace
} // namespace prosup::tests
