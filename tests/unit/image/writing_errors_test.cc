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
