#ifndef PROSUP_SRC_OUTPUT_OUTLINED_SLICE_H
#define PROSUP_SRC_OUTPUT_OUTLINED_SLICE_H

#include <functional>
#include <string>
#include <vector>

#include "canvas.h"
#include "slice_plane.h"

namespace prosup::output {

/// Beyond an image or a mesh.
constexpr Colour no_data_colour{52, 52, 52};

/// One plane as a picture of the report: with the outline of the breast, and the letters of the
/// patient's directions. Keeps a reference to the orientation.
class OutlinedSlice {
public:
  /// `mask` is not zero in the breast; `width` is that of the widest of the three, in pixels, which
  /// all have one scale.
  OutlinedSlice(const Orientation& orientation, const SliceBox& box, const image::LabelImage& mask,
                int width);

  const SlicePlane& plane() const { return plane_; }

  const Orientation& orientation() const { return orientation_; }

  /// The place of a pixel in lists that go row by row.
  std::size_t pixel(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(plane_.width()) +
           static_cast<std::size_t>(column);
  }

  bool is_breast(int column, int row) const { return is_breast_[pixel(column, row)]; }

  /// Row by row, whether a pixel lies at the border of what is inside.
  std::vector<bool> outline(const std::function<bool(const Point<3>&)>& is_inside) const;

  /// The address of a PNG of this colour at each pixel (column, row).
  std::string picture(const std::function<Colour(int, int)>& colour) const;

private:
  std::vector<bool> inside(const std::function<bool(const Point<3>&)>& is_inside) const;
  std::vector<bool> border(const std::vector<bool>& inside) const;

  const Orientation& orientation_;
  SlicePlane plane_;
  std::vector<bool> is_breast_, is_outline_;
};

} // namespace prosup::output

#endif
