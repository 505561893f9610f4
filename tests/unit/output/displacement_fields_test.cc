#include "prosup/output/displacement_fields.h"

#include <gtest/gtest.h>

#include <cmath>

#include "affine_mesh.h"
#include "expect_error.h"

namespace prosup::tests {
namespace {

using namespace prosup::output;

using dealii::Point;
using dealii::Tensor;
using evaluation::PointMapper;
using image::VectorImage;
using image::VoxelGrid;

const Point<3> low(-15., -12., -10.), high(15., 18., 20.);

VoxelGrid oblique_grid() {
  VoxelGrid grid;
  grid.size = {45, 50, 40};
  grid.spacing = Tensor<1, 3>({1.1, 1., 1.3});
  const double c = std::cos(0.3), s = std::sin(0.3);
  grid.direction = Tensor<2, 3>({{c, -s, 0.}, {s, c, 0.}, {0., 0., -1.}});
  grid.origin = Point<3>(-10., -32., 32.);
  return grid;
}

Point<3> position(const VoxelGrid& grid, std::size_t index) {
  const std::size_t i = index % grid.size[0], j = index / grid.size[0] % grid.size[1];
  return grid.physical(double(i), double(j), double(index / grid.size[0] / grid.size[1]));
}

Tensor<1, 3> value(const VectorImage& field, std::size_t index) {
  const auto& v = field.values[index];
  return Tensor<1, 3>({v[0], v[1], v[2]});
}

bool in_box(const Point<3>& p) {
  bool inside = true;
  for (unsigned d = 0; d < 3; ++d)
    inside = inside && p[d] > low[d] && p[d] < high[d];
  return inside;
}

struct FourFields {
  VectorImage unloaded_to_prone, unloaded_to_supine, prone_to_supine, supine_to_prone;
};

class Fields : public ::testing::Test {
protected:
  const AffineMap to_prone = stretch_and_shear();
  const AffineMap to_supine = other_stretch_and_shear();
  const mesh::TetMesh box = box_of_tets(low, high, 5);
  const mesh::UnloadedMesh prone = affine_mesh(box, to_prone);
  const mesh::UnloadedMesh supine = affine_mesh(box_of_tets(low, high, 7), to_supine);
  const VoxelGrid grid = oblique_grid();

  FourFields four_fields() const {
    const PointMapper prone_mapper(prone), supine_mapper(supine);
    return {unloaded_to_loaded(grid, prone, prone_mapper),
            unloaded_to_loaded(grid, supine, supine_mapper),
            loaded_to_loaded(grid, prone, prone_mapper, supine_mapper),
            loaded_to_loaded(grid, supine, supine_mapper, prone_mapper)};
  }
};

TEST_F(Fields, AreThoseOfTheAffineMapsInTheMesh) {
  const auto fields = four_fields();
  std::array<std::size_t, 3> n_inside{0, 0, 0};
  double largest_error = 0.;
  const auto check = [&](const VectorImage& field, std::size_t v, const Point<3>& target) {
    largest_error = std::max(largest_error, (position(grid, v) + value(field, v)).distance(target));
  };
  for (std::size_t v = 0; v < grid.n_voxels(); ++v) {
    const Point<3> p = position(grid, v);
    if (in_box(p)) {
      ++n_inside[0];
      check(fields.unloaded_to_prone, v, to_prone(p));
      check(fields.unloaded_to_supine, v, to_supine(p));
    }
    if (in_box(to_prone.inverse(p)) && ++n_inside[1] > 0)
      check(fields.prone_to_supine, v, to_supine(to_prone.inverse(p)));
    if (in_box(to_supine.inverse(p)) && ++n_inside[2] > 0)
      check(fields.supine_to_prone, v, to_prone(to_supine.inverse(p)));
  }
  for (const std::size_t n : n_inside)
    EXPECT_GT(n, 10000u);
  EXPECT_LT(largest_error, 1e-5); // single precision of values up to 20 mm
}

// Next to the mesh the field is that of the closest point; everywhere it stays
// within what the mesh has and has no jumps.
TEST_F(Fields, AreFiniteAndContinuousOutside) {
  const PointMapper mapper(prone);
  const VectorImage field = unloaded_to_loaded(grid, prone, mapper);
  double largest_in_mesh = 0., largest = 0., largest_step = 0.;
  std::size_t n_layer = 0;
  for (std::size_t v = 0; v < grid.n_voxels(); ++v) {
    const Point<3> p = position(grid, v);
    const double length = value(field, v).norm();
    ASSERT_TRUE(std::isfinite(length));
    largest = std::max(largest, length);
    const auto mapped = mapper.map(p, evaluation::Configuration::unloaded);
    if (mapped.distance_outside == 0.)
      largest_in_mesh = std::max(largest_in_mesh, length);
    if (mapped.distance_outside > 0. && mapped.distance_outside < 1.) {
      EXPECT_LT((p + value(field, v)).distance(mapped.position), 1e-5);
      ++n_layer;
    }
    if (v % grid.size[0] != 0)
      largest_step = std::max(largest_step, (value(field, v) - value(field, v - 1)).norm());
  }
  EXPECT_GT(n_layer, 2000u);
  EXPECT_LE(largest, largest_in_mesh + 0.5);
  // A step of 1.1 mm changes u by 1.1 |grad u| < 0.25 mm in the mesh, and by what
  // the ridges between nearest voxels make of it outside.
  EXPECT_LT(largest_step, 1.);
}

TEST_F(Fields, ThereAndBackReturns) {
  const auto fields = four_fields();
  std::size_t n = 0;
  for (std::size_t v = 0; v < grid.n_voxels(); ++v) {
    const Point<3> p = position(grid, v);
    const Point<3> q = grid.continuous_index(p + value(fields.prone_to_supine, v));
    // Affine fields are linear in the voxel index, so that any voxel inside
    // gives the value at q exactly.
    const std::size_t w = grid.linear_index(std::size_t(std::max(0., std::round(q[0]))),
                                            std::size_t(std::max(0., std::round(q[1]))),
                                            std::size_t(std::max(0., std::round(q[2]))));
    if (!in_box(to_prone.inverse(p)) || w >= grid.n_voxels() ||
        !in_box(to_supine.inverse(position(grid, w))))
      continue;
    const Tensor<2, 3> gradient = to_prone.A * invert(to_supine.A);
    const Point<3> x = p + value(fields.prone_to_supine, v);
    const Point<3> back =
        position(grid, w) + value(fields.supine_to_prone, w) + gradient * (x - position(grid, w));
    ASSERT_LT(back.distance(p), 5e-5);
    ++n;
  }
  EXPECT_GT(n, 10000u);
}

TEST_F(Fields, MeshOutsideTheGridIsAnError) {
  VoxelGrid far = grid;
  far.origin = Point<3>(500., 0., 0.);
  expect_error([&] { unloaded_to_loaded(far, prone, PointMapper(prone)); }, {"outside the grid"});
}

// The mesh may fill the grid, so that nothing is left to complete.
TEST_F(Fields, GridInsideTheMeshIsNoError) {
  VoxelGrid small;
  small.size = {3, 4, 5};
  const VectorImage field = unloaded_to_loaded(small, prone, PointMapper(prone));
  for (std::size_t v = 0; v < small.n_voxels(); ++v) {
    const Point<3> X = position(small, v);
    EXPECT_LT((X + value(field, v)).distance(to_prone(X)), 1e-5);
  }
}

} // namespace
} // namespace prosup::tests
