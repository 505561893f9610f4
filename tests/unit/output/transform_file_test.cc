#include "prosup/output/transform_file.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <limits>

#include "expect_error.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

/// A field of 3 x 2 x 2 voxels whose values are all different, on an oblique grid.
image::VectorImage small_field() {
  image::VoxelGrid grid;
  grid.size = {3, 2, 2};
  grid.origin = {-10., 20., 30.5};
  grid.spacing = dealii::Tensor<1, 3>({0.5, 1., 3.});
  grid.direction = dealii::Tensor<2, 3>({{0.6, -0.8, 0.}, {0.8, 0.6, 0.}, {0., 0., -1.}});
  image::VectorImage field(grid);
  for (std::size_t v = 0; v < field.values.size(); ++v)
    for (std::size_t d = 0; d < 3; ++d)
      field.values[v][d] = 0.1f * static_cast<float>(3 * v + d);
  return field;
}

template <typename Number>
std::vector<Number> read(hid_t file, const char* name, hid_t type) {
  const hid_t data = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(data);
  std::vector<Number> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_EQ(H5Sget_simple_extent_ndims(space), 1) << name;
  EXPECT_GE(H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << name;
  H5Sclose(space);
  H5Dclose(data);
  return values;
}

std::string read_text(hid_t file, const char* name) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  const std::vector<char*> words = read<char*>(file, name, type);
  H5Tclose(type);
  const std::string text = words.at(0);
  H5free_memory(words.at(0));
  return text;
}

// The layout is what itk::HDF5TransformIO writes; it cannot be read here by ITK, which brings
// another HDF5.
TEST(TransformFile, HasTheLayoutOfItk) {
  const TemporaryFolder folder;
  const image::VectorImage field = small_field();
  output::write_transform(field, folder / "field.h5");
  const hid_t file = H5Fopen((folder / "field.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  for (const char* name : {"ITKVersion", "HDFVersion", "OSName", "OSVersion"})
    EXPECT_FALSE(read_text(file, name).empty()) << name;
  EXPECT_EQ(read_text(file, "TransformGroup/0/TransformType"),
            "DisplacementFieldTransform_float_3_3");
  EXPECT_EQ(read<double>(file, "TransformGroup/0/TransformFixedParameters", H5T_NATIVE_DOUBLE),
            (std::vector<double>{3, 2, 2, -10, 20, 30.5, 0.5, 1, 3, 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0,
                                 -1}));
  const auto values = read<float>(file, "TransformGroup/0/TransformParameters", H5T_NATIVE_FLOAT);
  H5Fclose(file);
  ASSERT_EQ(values.size(), 3 * field.values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_EQ(values[i], field.values[i / 3][i % 3]);
}

TEST(TransformFile, IsTheSameEachTimeAndHoldsNumbersOnly) {
  const TemporaryFolder folder;
  image::VectorImage field = small_field();
  output::write_transform(field, folder / "a.h5");
  output::write_transform(field, folder / "b.h5");
  EXPECT_EQ(contents(folder / "a.h5"), contents(folder / "b.h5"));
  field.values[5][1] = std::numeric_limits<float>::quiet_NaN();
  expect_error([&] { output::write_transform(field, folder / "c.h5"); },
               {"c.h5", "not a finite number"});
  expect_error([&] { output::write_transform(small_field(), folder / "missing" / "d.h5"); },
               {"d.h5", "cannot be written"});
}

} // namespace
} // namespace prosup::tests
