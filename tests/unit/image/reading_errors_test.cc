#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "expect_error.h"
#include "prosup/image/image_io.h"
#include "temporary_folder.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

class Reading : public ::testing::Test {
protected:
  /// A MetaImage of zeros with the given header lines.
  std::filesystem::path meta_image(const std::string& header, std::size_t n_bytes) {
    const auto file = folder_ / "image.mha";
    std::ofstream out(file, std::ios::binary);
    out << "ObjectType = Image\n" << header << "ElementDataFile = LOCAL\n";
    out << std::string(n_bytes, '\0');
    return file;
  }

  TemporaryFolder folder_;
};

TEST_F(Reading, NamesAMissingFile) {
  expect_error([&] { read_image(folder_ / "absent.nii.gz"); }, {"absent.nii.gz", "does not exist"});
  expect_error([&] { read_labels(folder_ / "absent.nii.gz"); }, {"absent.nii.gz"});
  expect_error([&] { read_displacement(folder_ / "absent.nrrd"); }, {"absent.nrrd"});
}

TEST_F(Reading, RefusesAFolder) {
  std::filesystem::create_directory(folder_ / "dicom");
  expect_error([&] { read_image(folder_ / "dicom"); }, {"dicom", "is not a file", "NIfTI"});
}

TEST_F(Reading, ListsTheFormatsForAnUnknownOne) {
  std::ofstream(folder_ / "picture.nii.gz") << "this is no image";
  expect_error([&] { read_image(folder_ / "picture.nii.gz"); },
               {"picture.nii.gz", "NIfTI", "NRRD", "MetaImage"});
  std::ofstream(folder_ / "table.csv") << "1,2,3";
  expect_error([&] { read_image(folder_ / "table.csv"); }, {"table.csv", "NIfTI"});
}

TEST_F(Reading, RefusesATruncatedFile) {
  struct Case {
    const char* image;
    const char* data; // where its voxels are
  };
  for (const Case& c : {Case{"cut.nii", "cut.nii"},
                        {"cut.nii.gz", "cut.nii.gz"},
                        {"cut.nrrd", "cut.nrrd"},
                        {"cut.nhdr", "cut.raw.gz"},
                        {"cut.mha", "cut.mha"},
                        {"cut.mhd", "cut.zraw"}}) {
    write_image(random_image(oblique_grid()), folder_ / c.image);
    EXPECT_NO_THROW(read_image(folder_ / c.image)) << c.image;
    const auto data = folder_ / c.data;
    std::filesystem::resize_file(data, std::filesystem::file_size(data) - 200);
    expect_error([&] { read_image(folder_ / c.image); }, {"cut.", "damaged or incomplete"});
    std::filesystem::remove(data);
    expect_error([&] { read_image(folder_ / c.image); }, {"cut."});
  }
}

TEST_F(Reading, RefusesAFileWithDamagedContents) {
  const auto file = folder_ / "flipped.nii.gz";
  // Long enough for the header to be unpacked before the damage is met.
  write_image(random_image(cube_grid(40)), file);
  {
    std::fstream bytes(file, std::ios::binary | std::ios::in | std::ios::out);
    bytes.seekp(100000);
    bytes << "xxxx";
  }
  expect_error([&] { read_image(file); }, {"flipped.nii.gz", "damaged or incomplete"});
}

TEST_F(Reading, RefusesOtherDimensions) {
  const auto flat = meta_image("NDims = 2\nDimSize = 4 4\nElementType = MET_UCHAR\n", 16);
  expect_error([&] { read_image(flat); }, {"image.mha", "2 dimensions", "three-dimensional"});
  const auto series = meta_image("NDims = 4\nDimSize = 4 4 4 2\nElementType = MET_UCHAR\n", 128);
  expect_error([&] { read_image(series); }, {"image.mha", "4 dimensions"});
}

TEST_F(Reading, TakesDataFilesWithBlanksInTheirName) {
  write_image(random_image(oblique_grid()), folder_ / "two words.mhd");
  EXPECT_EQ(read_image(folder_ / "two words.mhd").grid.size, oblique_grid().size);
}

TEST_F(Reading, TakesAFourthDimensionOfOneVoxel) {
  const auto file = meta_image("NDims = 4\nDimSize = 4 3 2 1\nElementType = MET_UCHAR\n", 24);
  EXPECT_EQ(read_image(file).grid.size, (std::array<std::size_t, 3>{4, 3, 2}));
}

TEST_F(Reading, RefusesAWrongNumberOfComponents) {
  write_displacement(VectorImage(oblique_grid()), folder_ / "field.nrrd");
  expect_error([&] { read_image(folder_ / "field.nrrd"); }, {"field.nrrd", "3 values per voxel"});
  write_image(ScalarImage(oblique_grid()), folder_ / "scalar.nrrd");
  expect_error([&] { read_displacement(folder_ / "scalar.nrrd"); },
               {"scalar.nrrd", "1 values per voxel"});
}

TEST_F(Reading, RefusesSpacingThatIsNotPositive) {
  for (const char* spacing : {"0", "-1"}) {
    const auto file = meta_image(std::string("NDims = 3\nDimSize = 4 4 4\nElementSpacing = 1 ") +
                                     spacing + " 1\nElementType = MET_UCHAR\n",
                                 64);
    expect_error([&] { read_image(file); }, {"image.mha", "spacing", spacing, "axis 1"});
  }
}

TEST_F(Reading, RefusesShearedAxes) {
  const auto file = meta_image("NDims = 3\nDimSize = 4 4 4\n"
                               "TransformMatrix = 1 0 0 0.2 0.98 0 0 0 1\n"
                               "ElementType = MET_UCHAR\n",
                               64);
  expect_error([&] { read_image(file); }, {"image.mha", "right angles"});
}

TEST_F(Reading, RefusesValuesThatAreNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto file = folder_ / "image.mha";
  {
    std::ofstream out(file, std::ios::binary);
    out << "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 2\n"
           "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
    const float values[8] = {0.f, 1.f, 2.f, 3.f, 4.f, 5.f, nan, 7.f};
    out.write(reinterpret_cast<const char*>(values), sizeof(values));
  }
  // voxel 6 is (0, 1, 1)
  expect_error([&] { read_image(file); }, {"image.mha", "1 voxel", "(0.0, 1.0, 2.0)"});
}

TEST_F(Reading, RefusesValuesThatAreNoLabels) {
  for (const float bad : {0.5f, -1.f, 256.f}) {
    ScalarImage image(oblique_grid(), 1.f);
    image.values[5] = bad;
    write_image(image, folder_ / "mask.nii.gz");
    expect_error([&] { read_labels(folder_ / "mask.nii.gz"); },
                 {"mask.nii.gz", "integers from 0 to 255"});
  }
}

} // namespace
} // namespace prosup::tests
