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
constexpr double rounding = 1e-3; // mm, outside of the mesh: sqrt(3)/2048

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
    return {unloaded_to_loaded(grid, prone, prone_mapper).displacement,
            unloaded_to_loaded(grid, supine, supine_mapper).displacement,
            loaded_to_loaded(grid, prone, prone_mapper, supine_mapper).displacement,
            loaded_to_loaded(grid, supine, supine_mapper, prone_mapper).displacement};
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
  const VectorImage field = unloaded_to_loaded(grid, prone, mapper).displacement;
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
      EXPECT_LT((p + value(field, v)).distance(mapped.position), rounding);
      ++n_layer;
    }
    if (v % grid.size[0] != 0)
      largest_step = std::max(largest_step, (value(field, v) - value(field, v - 1)).norm());
  }
  EXPECT_GT(n_layer, 2000u);
  EXPECT_LE(largest, largest_in_mesh + 0.5);
  // A step of 1.1 mm changes u by 1.1 |grad u| < 0.25 mm in the mesh, by less than 0.75 mm where it
  // falls to the chest's motion, and by what the ridges between nearest voxels make of it.
  EXPECT_LT(largest_step, 1.5);
}

/// A turn by 0.02 about z with a shift: what two chests are apart.
image::RigidTransform small_motion() {
  image::RigidTransform motion;
  motion.rotation = image::rotation_about(Tensor<1, 3>({0., 0., 0.02}));
  motion.translation = Tensor<1, 3>({2., -1., 0.5});
  return motion;
}

TEST_F(Fields, MoveTheChestRigidlyAndTheMeshAsWithoutIt) {
  const PointMapper prone_mapper(prone), supine_mapper(supine);
  const image::RigidTransform motion = small_motion();
  const auto is_chest = [](const Point<3>& x) { return x[1] > 22.; };
  const StateField with =
      loaded_to_loaded(grid, prone, prone_mapper, supine_mapper, {motion, is_chest});
  const StateField without = loaded_to_loaded(grid, prone, prone_mapper, supine_mapper);
  std::size_t n_chest = 0, n_mesh = 0;
  for (std::size_t v = 0; v < grid.n_voxels(); ++v) {
    const Point<3> x = position(grid, v);
    if (in_box(to_prone.inverse(x))) {
      ++n_mesh;
      EXPECT_EQ(with.displacement.values[v], without.displacement.values[v]);
      EXPECT_EQ(with.valid.values[v], 1);
    } else if (is_chest(x)) {
      ++n_chest;
      EXPECT_LT((x + value(with.displacement, v)).distance(motion(x)), rounding);
      EXPECT_EQ(with.valid.values[v], 0);
    }
  }
  EXPECT_GT(n_mesh, 10000u);
  EXPECT_GT(n_chest, 1000u);
}

// Far away is twice the largest displacement, 9.2 mm here, and a voxel's diagonal.
TEST_F(Fields, FallToTheMotionOfTheChestFarAway) {
  const image::RigidTransform motion = small_motion();
  VoxelGrid wide;
  wide.size = {60, 60, 60};
  wide.spacing = Tensor<1, 3>({3., 3., 3.});
  wide.origin = Point<3>(-90., -87., -85.);
  const PointMapper mapper(prone);
  const VectorImage field = unloaded_to_loaded(wide, prone, mapper, {motion, {}}).displacement;
  std::size_t n_far = 0;
  for (std::size_t v = 0; v < wide.n_voxels(); ++v) {
    const Point<3> X = position(wide, v);
    if (mapper.distance_outside(X, evaluation::Configuration::unloaded) < 40.)
      continue;
    ++n_far;
    EXPECT_LT((X + value(field, v)).distance(motion(X)), rounding);
  }
  EXPECT_GT(n_far, 10000u);
}

// Air in front of a breast that grows stays in front of it: along a line away from the mesh no
// point overtakes another.
TEST_F(Fields, DoNotFoldBesideTheMesh) {
  mesh::UnloadedMesh flat{box_of_tets(low, high, 4), {}};
  flat.unloaded = flat.mesh.points;
  for (Point<3>& x : flat.mesh.points) // the front moves by 45 mm
    x[2] += 1.5 * (x[2] - low[2]);
  VoxelGrid line;
  line.size = {31, 31, 160};
  line.origin = Point<3>(-15., -12., -10.);
  const VectorImage field = unloaded_to_loaded(line, flat, PointMapper(flat)).displacement;
  for (std::size_t k = 1; k < line.size[2]; ++k) {
    const double before = double(k - 1) + double(field(15, 15, k - 1)[2]),
                 here = double(k) + double(field(15, 15, k)[2]);
    EXPECT_GT(here, before) << k;
  }
  EXPECT_GT(field(15, 15, 30)[2], 40.f);
  EXPECT_LT(field(15, 15, 155)[2], 0.1f);
}

TEST_F(Fields, FromLoadedToUnloadedAreTheInverse) {
  const PointMapper mapper(prone);
  const StateField field = loaded_to_unloaded(grid, prone, mapper);
  for (std::size_t v = 0; v < grid.n_voxels(); ++v) {
    const Point<3> x = position(grid, v);
    if (in_box(to_prone.inverse(x))) {
      EXPECT_LT((x + value(field.displacement, v)).distance(to_prone.inverse(x)), 1e-5);
    }
  }
}

// Tissue that the other mesh does not have is not valid.
TEST_F(Fields, AreNotValidWhereTheOtherMeshEnds) {
  const mesh::UnloadedMesh half =
      affine_mesh(box_of_tets(low, Point<3>(0., high[1], high[2]), 5), to_supine);
  const StateField field = loaded_to_loaded(grid, prone, PointMapper(prone), PointMapper(half));
  std::size_t n_valid = 0, n_not = 0;
  for (std::size_t v = 0; v < grid.n_voxels(); ++v) {
    const Point<3> X = to_prone.inverse(position(grid, v));
    if (!in_box(X) || (X[0] > -0.1 && X[0] < 2.1))
      continue;
    EXPECT_EQ(field.valid.values[v], X[0] < 0. ? 1 : 0) << X;
    ++(X[0] < 0. ? n_valid : n_not);
  }
  EXPECT_GT(n_valid, 4000u);
  EXPECT_GT(n_not, 4000u);
}

TEST(VoxelsWith, AreThoseOfTheNearestVoxel) {
  image::LabelImage labels;
  labels.grid.size = {3, 2, 2};
  labels.grid.spacing = Tensor<1, 3>({2., 2., 2.});
  labels.values = std::vector<std::uint8_t>(12, 0);
  labels(2, 1, 1) = 5;
  image::RigidTransform shift;
  shift.translation = Tensor<1, 3>({100., 0., 0.});
  const auto marked = voxels_with(labels, 5), shifted = voxels_with(labels, 5, shift);
  EXPECT_TRUE(marked({4.9, 1.1, 2.9}));
  EXPECT_FALSE(marked({5.1, 1.1, 2.9})); // outside
  EXPECT_FALSE(marked({2.9, 1.1, 2.9}));
  EXPECT_TRUE(shifted({-96., 2., 2.}));
  EXPECT_FALSE(voxels_with(image::LabelImage(), 0)({0., 0., 0.}));
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
  const VectorImage field = unloaded_to_loaded(small, prone, PointMapper(prone)).displacement;
  for (std::size_t v = 0; v < small.n_voxels(); ++v) {
    const Point<3> X = position(small, v);
    EXPECT_LT((X + value(field, v)).distance(to_prone(X)), 1e-5);
  }
}

} // namespace
} // namespace prosup::tests
