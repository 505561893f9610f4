#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/image/image_io.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

/// Slabs of `thickness` voxels, with another value each.
LabelImage slabs(std::size_t thickness, unsigned n_values) {
  VoxelGrid grid;
  grid.size = {120, 6, 5};
  LabelImage labels(grid);
  for (std::size_t v = 0; v < labels.values.size(); ++v)
    labels.values[v] = std::uint8_t(v % grid.size[0] / thickness % n_values);
  return labels;
}

TEST(Regions, AreToldFromIntensities) {
  EXPECT_NO_THROW(require_regions(slabs(4, 30), "many.nrrd"));
  EXPECT_NO_THROW(require_regions(slabs(1, 4), "thin.nrrd"));
  expect_error([] { require_regions(slabs(1, 30), "image.nrrd"); },
               {"image.nrrd", "30 different values", "give the mask"});
}

} // namespace
} // namespace prosup::tests
