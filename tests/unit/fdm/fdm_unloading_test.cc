#include "prosup/fdm/fdm_unloading.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "expect_error.h"
#include "voxel_box.h"

namespace prosup::tests {
namespace {

using namespace dealii;

const Tensor<1, 3> down({0., -standard_gravity, 0.});

fdm::Material material(double mu, double lambda) {
  fdm::Material result;
  result.tissues[2] = {mu, lambda};
  return result;
}

/// How far a point `depth` below the held end of a column of tissue of `length` sinks that
/// hangs between walls, by
/// P(F) = mu (F - 1/F) + lambda ln F/F = rho g (L - Y).
double column_sag(double mu, double lambda, double length, double depth) {
  constexpr int n = 2000;
  double sag = 0.;
  for (int i = 0; i < n; ++i) {
    const double load = tissue_density * standard_gravity * (length - depth * (i + 0.5) / n);
    double F = 1.;
    for (int iteration = 0; iteration < 50; ++iteration)
      F += (load - mu * (F - 1. / F) - lambda * std::log(F) / F) / (2. * mu + lambda);
    sag += (F - 1.) * depth / n;
  }
  return sag;
}

TEST(FdmUnloading, WideLayerSagsAsAColumn) {
  const VoxelBox box{1., 80., 20., 8.};
  fdm::FdmParameters parameters;
  parameters.spacing = 2.5;
  parameters.padding = 10.;
  fdm::FdmUnloading simulation(parameters, {box.labels(), 1, material(200., 300.), down},
                               MPI_COMM_WORLD);
  simulation.hold_reference();
  const settling::SettlingResult result = simulation.run();
  ASSERT_TRUE(result.converged) << result.explanation;
  const double sag = column_sag(200., 300., 20., 15.);
  // Not at the surface, over which material is smeared.
  const Tensor<1, 3> u = simulation.displacement().value(Point<3>(0., -15., 0.));
  EXPECT_NEAR(u[1], -sag, 0.08 * sag);
  EXPECT_LT(std::abs(u[0]) + std::abs(u[2]), 0.01 * sag);
}

TEST(FdmUnloading, BoxComesBackThroughVoxels) {
  // The paper's appendix on a grid twice as wide; it reports at most 0.6 mm and
  // 0.1 mm at the 95th percentile, of the order of its grid spacing of 0.5 mm.
  fdm::FdmParameters parameters;
  parameters.spacing = 1.;
  parameters.padding = 2.;
  const double mu = 500. / 2.9;
  const BoxExperiment result =
      box_experiment(parameters, {0.5, 15., 15., 6.}, material(mu, 9. * mu), down, MPI_COMM_WORLD);
  EXPECT_TRUE(result.loading.converged) << result.loading.explanation;
  EXPECT_TRUE(result.unloading.converged) << result.unloading.explanation;
  EXPECT_GT(result.moves, 1.5);
  EXPECT_LT(result.max_error, 1.2);
  EXPECT_LT(result.p95_error, 0.2);
}

/// A layer of tissue that goes on to the faces of the image.
image::LabelImage wide_layer() {
  const VoxelBox box{2., 24., 12., 8.};
  image::LabelImage labels = box.labels();
  for (std::size_t k = 0; k < labels.grid.size[2]; ++k)
    for (std::size_t j = 0; j < labels.grid.size[1]; ++j)
      for (std::size_t i = 0; i < labels.grid.size[0]; ++i)
        if (labels(i, j, k) == 0 &&
            labels.grid.physical(double(i), double(j), double(k))[1] > -box.depth)
          labels(i, j, k) = 2;
  return labels;
}

/// u at the face of the image after a while.
Tensor<1, 3> motion_at_the_border(const std::string& border, fdm::ChestContact contact) {
  fdm::FdmParameters parameters;
  parameters.spacing = 4.;
  parameters.padding = 12.;
  parameters.border = border;
  fdm::FdmUnloading simulation(
      parameters, {wide_layer(), 1, material(200., 300.), down, {contact, 0.}}, MPI_COMM_WORLD);
  simulation.advance(50);
  return simulation.displacement().value(Point<3>(19., -6., 0.));
}

TEST(FdmUnloading, BorderIsPaddedWhereTheChestHoldsTheTissue) {
  for (const auto contact : {fdm::ChestContact::fixed, fdm::ChestContact::sliding}) {
    const bool holds = contact == fdm::ChestContact::fixed;
    const Tensor<1, 3> automatic = motion_at_the_border("automatic", contact);
    const double to_padded = (automatic - motion_at_the_border("padded", contact)).norm(),
                 to_fixed = (automatic - motion_at_the_border("fixed", contact)).norm();
    EXPECT_EQ(holds ? to_padded : to_fixed, 0.);
    EXPECT_GT(holds ? to_fixed : to_padded, 1e-3);
  }
}

TEST(FdmUnloading, GoesBackWhenItDivergesAndSettles) {
  fdm::FdmParameters parameters;
  parameters.spacing = 1.;
  parameters.padding = 2.;
  parameters.background_stiffness = 0.002;
  const double mu = 500. / 2.9;
  const VoxelBox box{0.5, 15., 15., 6.};
  fdm::FdmUnloading simulation(parameters, {box.labels(), 1, material(mu, 9. * mu), down},
                               MPI_COMM_WORLD);
  const settling::SettlingResult result = simulation.run();
  EXPECT_TRUE(result.converged) << result.explanation;
  EXPECT_GE(result.n_retries, 1u);
}

TEST(FdmUnloading, MeshHoldsTheTissueAndItsVolume) {
  const VoxelBox box{1., 24., 24., 8.};
  fdm::FdmParameters parameters;
  parameters.spacing = 4.;
  parameters.padding = 8.;
  const image::LabelImage labels = box.labels();
  fdm::FdmUnloading simulation(parameters, {labels, 1, material(300., 2700.), down},
                               MPI_COMM_WORLD);
  const fdm::BreastMesh mesh = fdm::breast_mesh(simulation.displacement(), labels, {2});
  double volume = 0.;
  for (const auto& cell : mesh.cells) {
    const Tensor<1, 3> a = mesh.unloaded[cell[1]] - mesh.unloaded[cell[0]],
                       b = mesh.unloaded[cell[2]] - mesh.unloaded[cell[0]],
                       c = mesh.unloaded[cell[3]] - mesh.unloaded[cell[0]];
    const double six_volumes = cross_product_3d(a, b) * c;
    EXPECT_NEAR(six_volumes, 64., 1e-9);
    volume += six_volumes / 6.;
  }
  // The box is 24 mm; cells that are cut by its faces count whole.
  EXPECT_GE(volume, std::pow(24., 3) - 1e-6);
  EXPECT_LE(volume, std::pow(32., 3));
  EXPECT_EQ(mesh.tissue.size(), mesh.cells.size());
}

TEST(FdmUnloading, RefusesWhatItCannotSimulate) {
  const VoxelBox box{2., 16., 16., 6.};
  fdm::FdmParameters parameters;
  parameters.spacing = 4.;
  image::LabelImage labels = box.labels();
  const auto make = [&](const fdm::Material& tissues) {
    fdm::FdmUnloading(parameters, {labels, 1, tissues, down}, MPI_COMM_WORLD);
  };
  expect_error([&] { make(material(300., 0.)); }, {"both have to be positive"});
  fdm::Material other;
  other.tissues[7] = {300., 2700.};
  expect_error([&] { make(other); }, {"No voxel of body has the label of a tissue"});
  for (auto& label : labels.values)
    label = label == 1 ? 0 : label;
  expect_error([&] { make(material(300., 2700.)); }, {"Nothing holds body"});
}

TEST(FdmUnloading, DivergenceIsNeverASuccess) {
  // A box that falls apart under thirty times its weight.
  const VoxelBox box{2., 32., 32., 8.};
  fdm::FdmParameters parameters;
  parameters.spacing = 4.;
  parameters.padding = 12.;
  parameters.max_retries = 1;
  parameters.max_steps = 3000;
  fdm::FdmUnloading simulation(parameters, {box.labels(), 1, material(20., 180.), 30. * down},
                               MPI_COMM_WORLD);
  try {
    const settling::SettlingResult result = simulation.run();
    EXPECT_FALSE(result.converged);
    EXPECT_NE(result.explanation, "");
  } catch (const DivergenceError& error) {
    EXPECT_NE(std::string(error.what()).find("1 retries"), std::string::npos) << error.what();
  }
  for (const auto& u : simulation.displacement().values)
    ASSERT_TRUE(std::isfinite(u.norm()));
}

} // namespace
} // namespace prosup::tests
