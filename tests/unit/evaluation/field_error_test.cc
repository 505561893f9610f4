#include "prosup/evaluation/field_error.h"

#include <gtest/gtest.h>

#include "expect_error.h"

namespace prosup::tests {
namespace {

using namespace prosup::evaluation;

using dealii::Tensor;

/// A grid as NIfTI files give it, with voxels of three different edges.
image::VoxelGrid grid() {
  image::VoxelGrid grid;
  grid.size = {8, 9, 10};
  grid.origin = Point<3>(20., 30., -15.);
  grid.spacing = Tensor<1, 3>({1., 2., 3.});
  grid.direction[0][0] = grid.direction[1][1] = -1.;
  return grid;
}

/// d(x) = A x + b on all voxels; linear interpolation and central differences are exact.
image::VectorImage affine(const Tensor<2, 3>& a, const Tensor<1, 3>& b) {
  image::VectorImage field(grid());
  for (std::size_t k = 0; k < field.grid.size[2]; ++k)
    for (std::size_t j = 0; j < field.grid.size[1]; ++j)
      for (std::size_t i = 0; i < field.grid.size[0]; ++i) {
        const Tensor<1, 3> d =
            a * Tensor<1, 3>(field.grid.physical(double(i), double(j), double(k))) + b;
        field(i, j, k) = {float(d[0]), float(d[1]), float(d[2])};
      }
  return field;
}

Tensor<2, 3> matrix() {
  return Tensor<2, 3>({{0.1, 0.2, 0.}, {-0.05, -0.2, 0.1}, {0., 0.3, 0.15}});
}

TEST(FieldError, IsTheDistanceThatTheFieldLeaves) {
  const Tensor<1, 3> b({1., -2., 3.});
  const Point<3> at[] = {Point<3>(17.3, 21.1, -4.4), Point<3>(14.2, 29.9, 8.7)};
  std::vector<Landmark> landmarks(2);
  for (unsigned i = 0; i < 2; ++i) {
    landmarks[i].prone = at[i];
    landmarks[i].supine = at[i] + matrix() * Tensor<1, 3>(at[i]) + b;
  }
  landmarks[1].supine += Tensor<1, 3>({3., 0., -4.});
  const ErrorStatistics error = field_error(landmarks, affine(matrix(), b));
  EXPECT_EQ(error.n, 2u);
  EXPECT_NEAR(error.max, 5., 1e-4);
  EXPECT_NEAR(error.mean, 2.5, 1e-4);
}

TEST(FieldJacobian, IsTheDeterminantOfTheMap) {
  image::LabelImage mask(grid(), 1);
  const FieldJacobian jacobian = field_jacobian(affine(matrix(), {}), mask);
  // 1.1 (0.8 1.15 - 0.1 0.3) - 0.2 (-0.05 1.15)
  EXPECT_NEAR(jacobian.min, 0.9905, 1e-4);
  EXPECT_EQ(jacobian.folded_fraction, 0.);
}

TEST(FieldJacobian, TellsWhereAMapFolds) {
  image::VectorImage field = affine({}, {});
  // x -> -x/2 along the third axis above its middle: slope -1.5, and -0.75 across the kink.
  for (std::size_t k = 6; k < 10; ++k)
    for (std::size_t j = 0; j < 9; ++j)
      for (std::size_t i = 0; i < 8; ++i)
        field(i, j, k)[2] = float(-1.5 * 3. * double(k - 5));
  image::LabelImage mask(grid(), 1);
  const FieldJacobian jacobian = field_jacobian(field, mask);
  EXPECT_NEAR(jacobian.min, -0.5, 1e-5);
  EXPECT_NEAR(jacobian.folded_fraction, 3. / 8., 1e-12); // of layers 1 to 8: 6, 7, 8
  for (std::size_t k = 5; k < 10; ++k)
    for (std::size_t j = 0; j < 9; ++j)
      for (std::size_t i = 0; i < 8; ++i)
        mask(i, j, k) = 0;
  EXPECT_EQ(field_jacobian(field, mask).folded_fraction, 0.); // outside the breast
}

TEST(FieldJacobian, NeedsAMaskOnItsVoxels) {
  image::LabelImage other(image::grid_around(Point<3>(), Point<3>(5., 5., 5.), 1., 0.), 1);
  expect_error([&] { field_jacobian(affine({}, {}), other); }, {"voxels", "mask"});
  expect_error([&] { field_jacobian(affine({}, {}), image::LabelImage(grid())); },
               {"mask", "no voxel"});
}

} // namespace
} // namespace prosup::tests
