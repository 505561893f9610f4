#include "slice_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "prosup/image/sampling.h"

namespace prosup::output {

namespace {

constexpr float outside = std::numeric_limits<float>::quiet_NaN();

/// Samples an image scaled by its window.
class WindowedSampler {
public:
  explicit WindowedSampler(const ShownImage& shown)
      : sampler_(*shown.image), low_(shown.window.low),
        width_(shown.window.high - shown.window.low) {}

  float value(const Point<3>& p) const {
    if (!sampler_.inside(p))
      return outside;
    return static_cast<float>(
        std::clamp((static_cast<double>(sampler_.value(p)) - low_) / width_, 0., 1.));
  }

private:
  image::Sampler sampler_;
  double low_, width_;
};

} // namespace

const std::vector<Orientation>& orientations() {
  static const std::vector<Orientation> all = {{"axial", 0, 1, false, "R", "L", "A", "P"},
                                               {"sagittal", 1, 2, true, "A", "P", "S", "I"},
                                               {"coronal", 0, 2, true, "R", "L", "S", "I"}};
  return all;
}

SlicePlane::SlicePlane(const Orientation& orientation, const SliceBox& box, double pixels_per_mm)
    : orientation_(orientation), box_(box), mm_per_pixel_(1. / pixels_per_mm) {
  const auto n_pixels = [&](unsigned axis) {
    return std::max(1, static_cast<int>((box.high[axis] - box.low[axis]) * pixels_per_mm));
  };
  width_ = n_pixels(orientation.across);
  height_ = n_pixels(orientation.down);
}

Point<3> SlicePlane::position(int column, int row) const {
  Point<3> p = box_.centre;
  const unsigned across = orientation_.across, down = orientation_.down;
  p[across] = box_.low[across] + (column + 0.5) * mm_per_pixel_;
  p[down] = orientation_.down_reversed ? box_.high[down] - (row + 0.5) * mm_per_pixel_
                                       : box_.low[down] + (row + 0.5) * mm_per_pixel_;
  return p;
}

double common_scale(const SliceBox& box, int width) {
  double widest = 0.;
  for (const Orientation& orientation : orientations())
    widest = std::max(widest, box.high[orientation.across] - box.low[orientation.across]);
  return width / widest;
}

std::vector<float> sample(const Panel& panel, const SlicePlane& plane) {
  const WindowedSampler shown(panel.shown);
  const WindowedSampler subtract(panel.subtract.value_or(panel.shown));
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(plane.width() * plane.height()));
  for (int row = 0; row < plane.height(); ++row)
    for (int column = 0; column < plane.width(); ++column) {
      const Point<3> p = plane.position(column, row);
      values.push_back(shown.value(p) - (panel.subtract ? subtract.value(p) : 0.f));
    }
  return values;
}

} // namespace prosup::output
