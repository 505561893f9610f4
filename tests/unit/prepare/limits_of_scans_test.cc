// What a scan does not show, and what cannot be registered.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "expect_error.h"
#include "preparation_of.h"
#include "prosup/image/voxel_box.h"
#include "synthetic_chest.h"

namespace prosup::tests {
namespace {

using image::ScalarImage;

constexpr unsigned unknown = 255;

/// Calls `function(voxel, position)` for all voxels.
template <typename Function>
void for_voxels(const image::VoxelGrid& grid, const Function& function) {
  std::size_t v = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i, ++v)
        function(v, grid.physical(double(i), double(j), double(k)));
}

/// Whether a point lies beyond a reconstruction circle that cuts the sides of the chest.
bool is_beyond(const image::Point<3>& p) {
  return std::hypot(p[0], p[1] - 20.) > 100.;
}

ScalarImage padded(ScalarImage scan, float value) {
  for_voxels(scan.grid, [&](std::size_t v, const image::Point<3>& p) {
    if (is_beyond(p))
      scan.values[v] = value;
  });
  return scan;
}

void expect_unknown_beyond(const ScalarImage& scan) {
  const prepare::PreparedScan prepared = PreparationOf({}).run(scan);
  EXPECT_GT(prepared.unknown_contact, 20.); // cm^2
  double n = 0., n_beyond = 0., n_wrong = 0.;
  for_voxels(scan.grid, [&](std::size_t v, const image::Point<3>& p) {
    const bool is_unknown = prepared.labels.values[v] == unknown;
    n += is_unknown;
    n_beyond += is_beyond(p);
    n_wrong += is_unknown && !is_beyond(p);
  });
  EXPECT_GT(n, 0.95 * n_beyond); // corners of boxes
  EXPECT_EQ(n_wrong, 0.);
}

TEST(UnknownRegion, IsLabelledBeyondACircleOfCt) {
  expect_unknown_beyond(padded(SyntheticChest(hounsfield()).image, -2000.f));
}

TEST(UnknownRegion, IsLabelledBeyondTheEdgeOfMr) {
  ScalarImage scan = SyntheticChest().image;
  for (float& value : scan.values)
    value = std::abs(value) + 0.1f; // magnitudes
  expect_unknown_beyond(padded(std::move(scan), 0.f));
}

TEST(UnknownRegion, IsNotAirWithoutNoise) {
  SyntheticContrast contrast = hounsfield();
  contrast.noise = 0.;
  const prepare::PreparedScan prepared = PreparationOf({}).run(SyntheticChest(contrast).image);
  EXPECT_EQ(prepared.unknown_contact, 0.);
}

/// The left breast with a uniform ellipsoid of 99 ml.
ScalarImage with_implant(const SyntheticChest& chest, float value) {
  ScalarImage scan = chest.image;
  for_voxels(scan.grid, [&](std::size_t v, const image::Point<3>& p) {
    if (std::pow((p[0] - 60.) / 34., 2) + std::pow((p[1] - 10.) / 24., 2) +
            std::pow(p[2] / 29., 2) <
        1.)
      scan.values[v] = value + 0.25f * (chest.image.values[v] > 100.f); // not quite constant
  });
  return scan;
}

TEST(Implant, IsRefused) {
  const auto expect_refused = [](const ScalarImage& scan) {
    expect_error([&] { PreparationOf({}).run(scan); }, {"implant", "x = ", "ml"});
  };
  expect_refused(with_implant(SyntheticChest(), 15.f));              // T1
  expect_refused(with_implant(SyntheticChest(), 320.f));             // T2
  expect_refused(with_implant(SyntheticChest(hounsfield()), 120.f)); // CT
}

ScalarImage part(const ScalarImage& scan, std::array<std::size_t, 3> begin,
                 std::array<std::size_t, 3> end) {
  return image::part_of(scan, {begin, end});
}

// At the side, below and above; the planes are 60 mm from the middle, and the middle.
TEST(CutOffBreast, IsRefused) {
  const ScalarImage scan = SyntheticChest().image;
  const PreparationOf preparation({});
  expect_error(
      [&] {
        preparation.run(part(scan, {0, 0, 0}, {73, 61, 28}));
      },
      {"left breast", "cut off", "on the patient's left"});
  expect_error(
      [&] {
        preparation.run(part(scan, {0, 0, 14}, {98, 61, 28}));
      },
      {"cut off", "below", "cm^2"});
  expect_error([&] { preparation.run(part(scan, {0, 0, 0}, {98, 61, 14})); }, {"cut off", "above"});
  EXPECT_LT(preparation.run(scan).confidence.cut_share, 0.1);
}

} // namespace
} // namespace prosup::tests
