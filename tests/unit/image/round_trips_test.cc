#include <gtest/gtest.h>

#include "prosup/image/image_io.h"
#include "temporary_folder.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

class RoundTrip : public ::testing::TestWithParam<const char*> {
protected:
  std::filesystem::path file() const { return folder_ / (std::string("image") + GetParam()); }

  TemporaryFolder folder_;
};

// NIfTI and NRRD headers hold the geometry as float or in about six digits.
constexpr double tolerance_in_voxels = 1e-4;

TEST_P(RoundTrip, KeepsImageAndGeometry) {
  for (const VoxelGrid& grid : {flipped_grid(), oblique_grid()}) {
    const ScalarImage written = random_image(grid);
    write_image(written, file());
    const ScalarImage read = read_image(file());
    EXPECT_TRUE(read.grid.coincides_with(grid, tolerance_in_voxels));
    EXPECT_LT((read.grid.direction - grid.direction).norm(), 1e-5);
    EXPECT_EQ(read.values, written.values);
  }
}

TEST_P(RoundTrip, ReadsDirectionsOrthonormalToRounding) {
  write_image(random_image(oblique_grid()), file());
  const Tensor<2, 3> direction = read_image(file()).grid.direction;
  Tensor<2, 3> deviation = transpose(direction) * direction;
  for (unsigned d = 0; d < 3; ++d)
    deviation[d][d] -= 1.;
  EXPECT_LT(deviation.norm(), 1e-14);
}

TEST_P(RoundTrip, KeepsLabels) {
  LabelImage written(oblique_grid());
  for (std::size_t v = 0; v < written.values.size(); ++v)
    written.values[v] = static_cast<std::uint8_t>(v % 256);
  write_labels(written, file());
  const LabelImage read = read_labels(file());
  EXPECT_TRUE(read.grid.coincides_with(written.grid, tolerance_in_voxels));
  EXPECT_EQ(read.values, written.values);
  // the same file as an image: any scalar pixel type is read
  EXPECT_EQ(read_image(file()).values[200], 200.f);
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip,
                         ::testing::Values(".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd"),
                         [](const auto& info) {
                           std::string name;
                           for (const char* c = info.param; *c != '\0'; ++c)
                             if (*c != '.')
                               name += *c;
                           return name;
                         });

class DisplacementRoundTrip : public RoundTrip {};

TEST_P(DisplacementRoundTrip, KeepsVectors) {
  VectorImage written(oblique_grid());
  for (std::size_t v = 0; v < written.values.size(); ++v)
    written.values[v] = {float(v), -0.5f * float(v), 1.f / float(v + 1)};
  write_displacement(written, file());
  const VectorImage read = read_displacement(file());
  EXPECT_TRUE(read.grid.coincides_with(written.grid, tolerance_in_voxels));
  EXPECT_EQ(read.values, written.values);
}

INSTANTIATE_TEST_SUITE_P(Formats, DisplacementRoundTrip, ::testing::Values(".nrrd", ".mha"),
                         [](const auto& info) { return std::string(info.param + 1); });

} // namespace
} // namespace prosup::tests
