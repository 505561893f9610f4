#include "prosup/phantom/grids.h"

#include <cmath>

#include "expect_error.h"

namespace prosup::tests {
namespace {

using namespace prosup::phantom;

/// Largest |x|/(width/2) and |z|/(length/2) of the corner voxels.
double reach(const ImagingParameters& images, Position position) {
  const Geometry geometry;
  const image::VoxelGrid grid = image_grid(geometry, images, position);
  double largest = 0.;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double index[3];
    for (unsigned d = 0; d < 3; ++d)
      index[d] = (corner >> d & 1u) ? double(grid.size[d]) - 1. : 0.;
    const auto x = grid.physical(index[0], index[1], index[2]);
    largest = std::max(
        {largest, 2. * std::abs(x[0]) / geometry.width, 2. * std::abs(x[2]) / geometry.length});
  }
  return largest;
}

TEST(Grids, EndWithinTheCutPlanes) {
  ImagingParameters images;
  EXPECT_LE(reach(images, Position::prone), 1.);
  EXPECT_GT(reach(images, Position::prone), 0.97);
  images.supine_offset = dealii::Tensor<1, 3>({0.4, -0.3, 0.45});
  images.rotation = dealii::Tensor<1, 3>({4., -8., 10.});
  for (const Position position : both_positions) {
    EXPECT_LE(reach(images, position), 1.);
    EXPECT_GT(reach(images, position), 0.95);
  }
}

TEST(Grids, OffsetShiftsTheSupineVoxelsByPartsOfOne) {
  ImagingParameters images;
  const auto before = image_grid({}, images, Position::supine);
  images.supine_offset = dealii::Tensor<1, 3>({0.25, 0.25, 0.25});
  EXPECT_TRUE(before.coincides_with(image_grid({}, images, Position::prone)));
  const auto shifted = image_grid({}, images, Position::supine);
  for (unsigned d = 0; d < 3; ++d)
    EXPECT_GT(std::abs(std::remainder(shifted.origin[d] - before.origin[d], 0.5)), 0.2);
}

TEST(Grids, OfTheMesherEndInTheCutPlanes) {
  const Geometry geometry;
  const auto grid = meshing_grid(geometry, 2.);
  EXPECT_NEAR(grid.spacing[0] * double(grid.size[0]), geometry.width, 1e-9);
  EXPECT_NEAR(grid.origin[2] - 0.5 * grid.spacing[2], -0.5 * geometry.length, 1e-9);
}

TEST(Grids, RefuseToShowNextToNothing) {
  ImagingParameters images;
  images.supine_crop = 70.;
  EXPECT_NO_THROW(image_grid({}, images, Position::prone));
  expect_error([&] { image_grid({}, images, Position::supine); },
               {"Phantom/Images/Rotation", "Supine crop"});
}

} // namespace
} // namespace prosup::tests
