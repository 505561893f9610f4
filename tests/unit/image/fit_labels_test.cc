#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/image/image_io.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

/// 1 in the part of the grid with x > limit, mm, and 2 beside it.
LabelImage halves(const VoxelGrid& grid, double limit) {
  LabelImage labels(grid, 2);
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        if (grid.physical(double(i), double(j), double(k))[0] > limit)
          labels(i, j, k) = 1;
  return labels;
}

VoxelGrid box(std::size_t n, double spacing, double start) {
  VoxelGrid grid;
  grid.size = {n, n, n};
  grid.spacing = Tensor<1, 3>({spacing, spacing, spacing});
  grid.origin = Point<3>(start, start, start);
  return grid;
}

const ScalarImage picture(box(20, 2., 1.)); // from 0 to 40 mm

LabelImage fitted(LabelImage labels, Remarks& remarks) {
  return fit_labels(std::move(labels), picture, "mask.nrrd", "image.nii", remarks);
}

TEST(FitLabels, RoundingOfHeadersIsNoDifference) {
  for (const double factor : {1., 1.0005, 0.9995}) {
    VoxelGrid grid = picture.grid;
    grid.spacing *= factor; // 2.000 against 2.001 mm
    grid.origin[0] += 1e-4;
    Remarks remarks;
    const LabelImage labels = fitted(halves(grid, 20.), remarks);
    EXPECT_TRUE(remarks.all().empty());
    EXPECT_EQ(labels.grid.origin, picture.grid.origin);
    EXPECT_EQ(labels.grid.spacing, picture.grid.spacing);
    EXPECT_EQ(labels.values, halves(picture.grid, 20.).values);
  }
}

TEST(FitLabels, OtherGridsOfTheSameFrameAreResampled) {
  VoxelGrid flipped = box(40, 1., 0.5); // the same box, axes exchanged and turned round
  flipped.direction = Tensor<2, 3>({{0., -1., 0.}, {1., 0., 0.}, {0., 0., 1.}});
  flipped.origin = Point<3>(39.5, 0.5, 0.5);
  for (const VoxelGrid& grid : {box(40, 1., 0.5), box(10, 4., 2.), box(21, 2., -1.), flipped}) {
    Remarks remarks;
    const LabelImage labels = fitted(halves(grid, 20.), remarks);
    EXPECT_EQ(labels.grid.size, picture.grid.size);
    EXPECT_EQ(labels.values, halves(picture.grid, 20.).values);
    ASSERT_EQ(remarks.all().size(), 1u);
    EXPECT_NE(remarks.all()[0].find("'mask.nrrd'"), std::string::npos);
    EXPECT_NE(remarks.all()[0].find("nearest voxel"), std::string::npos);
  }
}

TEST(FitLabels, WhatACroppedMaskDoesNotCoverIsAir) {
  Remarks remarks;
  const LabelImage labels = fitted(halves(box(10, 2., 11.), 20.), remarks); // 10 to 30 mm
  for (std::size_t v = 0; v < labels.values.size(); ++v) {
    const std::size_t i = v % 20, j = v / 20 % 20, k = v / 400;
    const bool covered = std::min({i, j, k}) >= 5 && std::max({i, j, k}) < 15;
    EXPECT_EQ(labels.values[v], !covered ? 0 : i >= 10 ? 1 : 2);
  }
  EXPECT_EQ(remarks.all().size(), 1u);
  EXPECT_EQ(remarks.all()[0].find("lost"), std::string::npos);
  fitted(halves(box(12, 2., 21.), 30.), remarks); // 20 to 44 mm
  EXPECT_NE(remarks.all().back().find("42.1 % of them are lost"), std::string::npos)
      << remarks.all().back();
}

TEST(FitLabels, OtherPlacesAndFramesAreRefused) {
  const auto refused = [](const VoxelGrid& grid, const std::vector<std::string>& fragments) {
    Remarks remarks;
    auto parts = fragments;
    parts.insert(parts.end(), {"image.nii", "mask.nrrd"});
    expect_error([&] { fitted(halves(grid, 20.), remarks); }, parts);
  };
  refused(box(20, 1., 1.), {"spacing (1, 1, 1)", "(2, 2, 2)"});
  refused(box(20, 2., 4.), {"origin (4, 4, 4)", "(1, 1, 1)"});
  refused(box(12, 2., 200.), {"only 0 %", "origin (200, 200, 200)"});
  VoxelGrid grid = box(21, 2., 0.);
  grid.direction = Tensor<2, 3>({{.8, -.6, 0.}, {.6, .8, 0.}, {0., 0., 1.}});
  refused(grid, {"direction cosines ((0.8, -0.6, 0)"});
  grid = picture.grid;
  grid.direction[0][0] = -1.;
  refused(grid, {"direction cosines ((-1, 0, 0)"});
}

} // namespace
} // namespace prosup::tests
