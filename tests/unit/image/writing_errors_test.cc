#include <gtest/gtest.h>

#include <limits>

#include "expect_error.h"
#include "prosup/image/image_io.h"
#include "temporary_folder.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

TEST(Writing, RefusesUnknownEndingsAndFolders) {
  const TemporaryFolder folder;
  const ScalarImage image(oblique_grid());
  expect_error([&] { write_image(image, folder / "image.xyz"); }, {"image.xyz", "NIfTI"});
  expect_error([&] { write_image(image, folder / "absent/image.nii"); },
               {"absent/image.nii", "folder does not exist"});
}

TEST(Writing, LetsNoNanReachAFile) {
  const TemporaryFolder folder;
  ScalarImage image(oblique_grid());
  image.values[3] = std::numeric_limits<float>::quiet_NaN();
  expect_error([&] { write_image(image, folder / "image.nii.gz"); }, {"image.nii.gz", "finite"});
  EXPECT_FALSE(std::filesystem::exists(folder / "image.nii.gz"));
  VectorImage field(oblique_grid());
  field.values[3][2] = std::numeric_limits<float>::infinity();
  expect_error([&] { write_displacement(field, folder / "u.nrrd"); }, {"u.nrrd", "finite"});
  EXPECT_FALSE(std::filesystem::exists(folder / "u.nrrd"));
}

TEST(Writing, RefusesDisplacementsInNifti) {
  const TemporaryFolder folder;
  expect_error([&] { write_displacement(VectorImage(oblique_grid()), folder / "u.nii.gz"); },
               {"u.nii.gz", "NRRD"});
}

TEST(LabelChecks, SayHowGridsDiffer) {
  const ScalarImage image(flipped_grid());
  const auto message = [&](const VoxelGrid& grid, const std::vector<std::string>& fragments) {
    expect_error([&] { check_labels_fit(image, LabelImage(grid), "a.nii", "a_labels.nii"); },
                 fragments);
  };
  VoxelGrid grid = image.grid;
  grid.size[2] = 6;
  message(grid, {"a.nii", "a_labels.nii", "size 9 x 8 x 6", "9 x 8 x 7"});
  grid = image.grid;
  grid.spacing[1] = 1.5;
  message(grid, {"spacing (1.5, 1.5, 2.5)", "(1.5, 1.25, 2.5)"});
  grid = image.grid;
  grid.direction[0][0] = 1.;
  message(grid, {"direction", "(1, 0, 0)", "(-1, 0, 0)"});
  grid = image.grid;
  grid.origin[0] = 31.;
  message(grid, {"origin (31, 12, -41)", "(30, 12, -41)"});
  EXPECT_NO_THROW(check_labels_fit(image, LabelImage(image.grid), "a.nii", "a_labels.nii"));
}

TEST(LabelChecks, SayWhichLabelsArePresent) {
  LabelImage labels(flipped_grid());
  labels.values[4] = 2;
  labels.values[7] = 14;
  EXPECT_NO_THROW(require_label(labels, 14, "fat", "mask.nii"));
  expect_error([&] { require_label(labels, 3, "gland", "mask.nii"); },
               {"mask.nii", "label 3 (gland)", "only of 0, 2, 14"});
  expect_error([&] { require_label(labels, 1000, "fat", "mask.nii"); }, {"label 1000 (fat)"});
}

} // namespace
} // namespace prosup::tests
