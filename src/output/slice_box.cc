#include <algorithm>
#include <limits>

#include "prosup/core/error.h"
#include "prosup/output/pictures.h"

namespace prosup::output {

namespace {

using image::LabelImage;
using image::VoxelGrid;

struct Box {
  Point<3> low, high;

  Box() {
    for (unsigned d = 0; d < 3; ++d) {
      low[d] = std::numeric_limits<double>::max();
      high[d] = std::numeric_limits<double>::lowest();
    }
  }

  void include(const Point<3>& p) {
    for (unsigned d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], p[d]);
      high[d] = std::max(high[d], p[d]);
    }
  }
};

void include_field_of_view(Box& box, const VoxelGrid& grid) {
  const auto end = [&](unsigned d, bool upper) {
    return upper ? static_cast<double>(grid.size[d]) - 0.5 : -0.5;
  };
  for (unsigned corner = 0; corner < 8; ++corner)
    box.include(grid.physical(end(0, corner & 1u), end(1, corner & 2u), end(2, corner & 4u)));
}

/// Puts what is not zero into the box; returns its centre of mass.
Point<3> include_mask(Box& box, const LabelImage& mask) {
  Point<3> sum;
  std::size_t n = 0;
  const auto& size = mask.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i) {
        if (mask(i, j, k) == 0)
          continue;
        const Point<3> p = mask.grid.physical(static_cast<double>(i), static_cast<double>(j),
                                              static_cast<double>(k));
        box.include(p);
        sum += dealii::Tensor<1, 3>(p);
        ++n;
      }
  if (n == 0)
    throw Error("No picture can be made because a breast mask is empty; check the tissue labels.");
  return sum / static_cast<double>(n);
}

} // namespace

SliceBox slice_box(const std::vector<const LabelImage*>& masks) {
  // Enough to see the chest wall, which is behind the breast, and the air.
  constexpr double margin_mm = 15.;
  Box tissue, field_of_view;
  SliceBox result;
  for (const LabelImage* mask : masks) {
    result.centre +=
        dealii::Tensor<1, 3>(include_mask(tissue, *mask)) / static_cast<double>(masks.size());
    include_field_of_view(field_of_view, mask->grid);
  }
  for (unsigned d = 0; d < 3; ++d) {
    result.low[d] = std::max(tissue.low[d] - margin_mm, field_of_view.low[d]);
    result.high[d] = std::min(tissue.high[d] + margin_mm, field_of_view.high[d]);
  }
  return result;
}

} // namespace prosup::output
