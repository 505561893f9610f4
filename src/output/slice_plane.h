#ifndef PROSUP_OUTPUT_SLICE_PLANE_H
#define PROSUP_OUTPUT_SLICE_PLANE_H

#include "prosup/output/pictures.h"

namespace prosup::output {

/// A plane of LPS space as it is laid on paper.
struct Orientation {
  const char* name;
  unsigned across, down;                   ///< axes of space that run along a row and a column
  bool down_reversed;                      ///< true where the coordinate falls down the picture
  const char *left, *right, *top, *bottom; ///< letters of the patient's directions
};

/// Axial, sagittal and coronal in the radiologist's convention.
const std::vector<Orientation>& orientations();

/// The pixels of a slice through the centre of a box.
class SlicePlane {
public:
  SlicePlane(const Orientation& orientation, const SliceBox& box, double pixels_per_mm);

  int width() const { return width_; }
  double width_mm() const { return width_ * mm_per_pixel_; }
  int height() const { return height_; }

  /// Physical position of the middle of a pixel.
  Point<3> position(int column, int row) const;

private:
  const Orientation& orientation_;
  SliceBox box_;
  double mm_per_pixel_;
  int width_, height_;
};

/// Pixels per mm with which the widest slice through a box has this width, in pixels.
double common_scale(const SliceBox& box, int width);

/// Intensities of a panel on a plane, row by row: 0 (black) to 1 (white), or -1
/// to 1 for a difference; no number outside the field of view.
std::vector<float> sample(const Panel& panel, const SlicePlane& plane);

} // namespace prosup::output

#endif
