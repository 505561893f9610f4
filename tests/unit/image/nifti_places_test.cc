// Where the voxels of NIfTI files are.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "expect_error.h"
#include "nifti_bytes.h"
#include "prosup/image/image_io.h"
#include "temporary_folder.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;
using field = nifti_field;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class NiftiPlaces : public ::testing::Test {
protected:
  VoxelGrid read(const NiftiBytes& bytes, NiftiTransform transform = NiftiTransform::must_agree) {
    write_bytes(bytes.all(), file_);
    remarks_ = Remarks();
    return read_image(file_, remarks_, transform).grid;
  }

  /// Reads and expects one remark with all `fragments`, or none if there are none.
  VoxelGrid read(const NiftiBytes& bytes, const std::vector<std::string>& fragments,
                 NiftiTransform transform = NiftiTransform::must_agree) {
    const VoxelGrid grid = read(bytes, transform);
    EXPECT_EQ(remarks_.all().size(), fragments.empty() ? 0u : 1u);
    for (const std::string& fragment : fragments)
      for (const std::string& remark : remarks_.all())
        EXPECT_NE(remark.find(fragment), std::string::npos) << remark;
    return grid;
  }

  /// Where the voxel is that holds `value`: 1, 4 and 12 are the neighbours of the first one along
  /// the axes of the file.
  Point<3> place_of(float value, const NiftiBytes& bytes) {
    write_bytes(bytes.all(), file_);
    const ScalarImage image = read_image(file_);
    const auto voxel = std::find(image.values.begin(), image.values.end(), value);
    const auto v = static_cast<std::size_t>(voxel - image.values.begin());
    const auto& size = image.grid.size;
    return image.grid.physical(double(v % size[0]), double(v / size[0] % size[1]),
                               double(v / size[0] / size[1]));
  }

  /// The place of the voxels of NiftiBytes, which is LPS here.
  static VoxelGrid usual() {
    VoxelGrid grid;
    grid.size = {4, 3, 2};
    grid.origin = Point<3>(-10., -20., 30.);
    grid.spacing = Tensor<1, 3>({1.5, 2., 3.});
    grid.direction[0][0] = grid.direction[1][1] = -1.;
    return grid;
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "image.nii";
  Remarks remarks_;
};

TEST_F(NiftiPlaces, AreThoseOfTheTransformThatIsThere) {
  EXPECT_TRUE(read(NiftiBytes(), {}).coincides_with(usual(), 1e-12));
  EXPECT_TRUE(read(NiftiBytes(true), {}).coincides_with(usual(), 1e-12));
  EXPECT_TRUE(read(NiftiBytes().put<std::int16_t>(field::qform_code, {0, 2}), {})
                  .coincides_with(usual(), 1e-12));
  EXPECT_TRUE(read(NiftiBytes().put<std::int16_t>(field::qform_code, {4, 0}), {})
                  .coincides_with(usual(), 1e-12));
  const auto neither = NiftiBytes().put<std::int16_t>(field::qform_code, {0, 0});
  expect_error([&] { read(neither); }, {"image.nii", "where the image is", "codes"});
}

TEST_F(NiftiPlaces, FollowTheQuaternionAndItsHandedness) {
  // A quarter turn about z takes the first axis to anterior; qfac turns the third one round.
  auto bytes = NiftiBytes().put<std::int16_t>(field::qform_code, {1, 0});
  bytes.put<float>(field::pixdim, {-1.f});
  bytes.put<float>(field::quatern, {0.f, 0.f, float(std::sqrt(0.5))});
  EXPECT_LT(place_of(1.f, bytes).distance(Point<3>(-10., -21.5, 30.)), 1e-5);
  EXPECT_LT(place_of(4.f, bytes).distance(Point<3>(-8., -20., 30.)), 1e-5);
  EXPECT_LT(place_of(12.f, bytes).distance(Point<3>(-10., -20., 27.)), 1e-5);
  // 0 and what is no sign stand for 1; half a turn may be a little more than one by rounding.
  bytes.put<float>(field::pixdim, {0.f});
  EXPECT_LT(place_of(12.f, bytes).distance(Point<3>(-10., -20., 33.)), 1e-5);
  bytes.put<float>(field::quatern, {0.f, 0.f, 1.000001f});
  EXPECT_LT(place_of(1.f, bytes).distance(Point<3>(-8.5, -20., 30.)), 1e-5);
}

TEST_F(NiftiPlaces, AreNumbersAsTheyWereMeant) {
  auto bytes = NiftiBytes().put<float>(field::pixdim + 4, {0.7f, 2.f, 3.f});
  bytes.put<float>(field::srow, {0.7f, 0.f, 0.f, 10.1f});
  bytes.put<float>(field::qoffset, {10.1f});
  const VoxelGrid grid = read(bytes, {});
  EXPECT_EQ(grid.spacing[0], 0.7);
  EXPECT_EQ(grid.origin[0], -10.1);
}

TEST_F(NiftiPlaces, AreRefusedWhereTheTransformsDisagree) {
  // 0.3 mm are 0.15 voxels along y
  auto bytes = NiftiBytes().put<float>(field::qoffset, {10.f, 20.3f, 30.f});
  expect_error([&] { read(bytes); },
               {"image.nii", "sform (code 1)", "qform (code 1)", "(-10.00, -20.00, 30.00)",
                "(-10.00, -20.30, 30.00)", "0.3 mm", "Images/NIfTI transform"});
  EXPECT_NEAR(read(bytes, {"sform was taken", "0.3 mm"}, NiftiTransform::sform).origin[1], -20.,
              1e-6);
  EXPECT_NEAR(read(bytes, {"qform was taken", "0.3 mm"}, NiftiTransform::qform).origin[1], -20.3,
              1e-6);
  bytes.put<float>(field::qoffset, {10.f, 20.15f, 30.f}); // 0.075 voxels
  EXPECT_NEAR(read(bytes, {}).origin[1], -20., 1e-6);
}

TEST_F(NiftiPlaces, AreComparedInTheWholeImage) {
  // 4 degrees move the first voxel by nothing, and the last one by 0.1 mm and more.
  auto bytes = NiftiBytes().put<float>(field::quatern, {0.f, 0.f, float(std::sin(M_PI / 90.))});
  expect_error([&] { read(bytes); }, {"image.nii", "sform", "qform", "in the image"});
  // left and right exchanged
  bytes = NiftiBytes().put<float>(field::srow, {-1.5f, 0.f, 0.f, 14.5f});
  expect_error([&] { read(bytes); }, {"image.nii", "sform", "qform"});
}

TEST_F(NiftiPlaces, SurviveAnSformWithoutVoxelSize) {
  const std::vector<float> unit{1.f, 0.f, 0.f, 10.f, 0.f, 1.f, 0.f, 20.f, 0.f, 0.f, 1.f, 30.f};
  auto bytes = NiftiBytes().put<float>(field::srow, unit);
  EXPECT_TRUE(read(bytes, {"lacks the voxel size", "qform was taken"}).coincides_with(usual()));
  // nothing else tells whether the voxels are of 1 mm
  bytes.put<std::int16_t>(field::qform_code, {0, 1});
  expect_error([&] { read(bytes); }, {"image.nii", "1 x 1 x 1", "1.5 x 2 x 3", "sform"});
  EXPECT_EQ(read(bytes, {"sform was taken"}, NiftiTransform::sform).spacing[2], 1.);
  expect_error([&] { read(bytes, NiftiTransform::qform); }, {"1 x 1 x 1"});
}

TEST_F(NiftiPlaces, MayHaveOneTransformThatIsNone) {
  for (const float bad : {nan, std::numeric_limits<float>::infinity(), 3.f}) {
    const auto bytes = NiftiBytes().put<float>(field::quatern, {bad});
    EXPECT_TRUE(read(bytes, {"qform", "sform was taken"}).coincides_with(usual(), 1e-12)) << bad;
  }
  for (const float bad : {nan, std::numeric_limits<float>::infinity()}) {
    const auto bytes = NiftiBytes().put<float>(field::srow, {bad});
    EXPECT_TRUE(read(bytes, {"sform", "qform was taken"}).coincides_with(usual())) << bad;
  }
  const auto zeros = NiftiBytes().put<float>(field::srow, std::vector<float>(12, 0.f));
  EXPECT_TRUE(read(zeros, {"sform", "qform was taken"}).coincides_with(usual()));
  auto neither = zeros;
  neither.put<float>(field::qoffset, {nan});
  expect_error([&] { read(neither); }, {"image.nii", "neither", "qform", "sform"});
}

TEST_F(NiftiPlaces, TakeVoxelSizesWithoutTheirSigns) {
  auto bytes = NiftiBytes().put<float>(field::pixdim, {1.f, 1.5f, -2.f, 3.f});
  EXPECT_TRUE(read(bytes, {"1.5 x -2 x 3", "signs"}).coincides_with(usual()));
  bytes.put<std::int16_t>(field::qform_code, {1, 0});
  EXPECT_TRUE(read(bytes, {"signs"}).coincides_with(usual()));
  for (const float bad : {0.f, nan}) {
    bytes = NiftiBytes().put<float>(field::pixdim, {1.f, 1.5f, bad, 3.f});
    bytes.put<std::int16_t>(field::qform_code, {0, 1});
    EXPECT_TRUE(read(bytes, {"voxel size", "ignored"}).coincides_with(usual()));
    bytes.put<std::int16_t>(field::qform_code, {1, 0});
    expect_error([&] { read(bytes); }, {"image.nii", "neither"});
  }
}

TEST_F(NiftiPlaces, RefuseShear) {
  const std::vector<float> sheared{1.5f, 0.4f, 0.f, 10.f, 0.f, 2.f, 0.f, 20.f};
  auto bytes = NiftiBytes().put<float>(field::srow, sheared);
  expect_error([&] { read(bytes); }, {"image.nii", "sform", "qform"});
  EXPECT_TRUE(read(bytes, {"qform was taken"}, NiftiTransform::qform).coincides_with(usual()));
  expect_error([&] { read(bytes, NiftiTransform::sform); }, {"image.nii", "right angles"});
  bytes.put<std::int16_t>(field::qform_code, {0, 1});
  expect_error([&] { read(bytes); }, {"image.nii", "sform"});
  expect_error([&] { read(bytes, NiftiTransform::sform); }, {"image.nii", "right angles"});
}

TEST_F(NiftiPlaces, AreInTheUnitOfTheHeader) {
  for (const auto& [code, millimetres] : {std::pair(1, 1e3f), {3, 1e-3f}, {0, 1.f}, {2, 1.f}})
    for (const auto& codes : {std::vector<std::int16_t>{1, 0}, {0, 1}, {1, 1}}) {
      auto bytes = NiftiBytes().put<std::int16_t>(field::qform_code, codes);
      const float x = 1.f / millimetres;
      bytes.put<float>(field::pixdim + 4, {1.5f * x, 2.f * x, 3.f * x});
      bytes.put<float>(field::qoffset, {10.f * x, 20.f * x, 30.f * x});
      bytes.put<float>(field::srow, {1.5f * x, 0.f, 0.f, 10.f * x, 0.f, 2.f * x, 0.f, 20.f * x, 0.f,
                                     0.f, 3.f * x, 30.f * x});
      bytes.put<char>(field::xyzt_units, {static_cast<char>(code + 8)}); // and seconds
      EXPECT_TRUE(read(bytes, {}).coincides_with(usual(), 1e-5)) << code;
    }
  EXPECT_TRUE(read(NiftiBytes().put<char>(field::xyzt_units, {5}), {"unit", "mm was assumed"})
                  .coincides_with(usual()));
}

TEST_F(NiftiPlaces, AreWrittenAlikeInBothTransforms) {
  for (const VoxelGrid& grid : {flipped_grid(), oblique_grid()}) {
    write_image(ScalarImage(grid), file_);
    std::string bytes(348, '\0');
    std::ifstream(file_, std::ios::binary).read(bytes.data(), 348);
    std::int16_t codes[2];
    std::memcpy(codes, bytes.data() + field::qform_code, 4);
    EXPECT_GT(codes[0], 0);
    EXPECT_GT(codes[1], 0);
    for (const std::size_t code : {field::qform_code, field::sform_code}) {
      std::string one = bytes + std::string(4 + grid.n_voxels() * 4, '\0');
      one.replace(code, 2, std::string(2, '\0'));
      write_bytes(one, folder_ / "one.nii");
      EXPECT_TRUE(read_image(folder_ / "one.nii").grid.coincides_with(grid, 1e-4));
    }
  }
}

} // namespace
} // namespace prosup::tests
