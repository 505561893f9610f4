#ifndef PROSUP_BENCHMARKS_HARD_CASES_SHAPES_H
#define PROSUP_BENCHMARKS_HARD_CASES_SHAPES_H

#include <functional>
#include <string>

#include "prosup/image/voxel_image.h"

namespace prosup::benchmarks {

using dealii::Point;
using dealii::Tensor;

/// A breast as it was imaged, on a chest that is a cylinder along z: the labels
/// of a box in space. The image ends where tissue and chest are cut.
struct Shape {
  std::string name;
  Point<3> low, high;                               ///< of the image, LPS mm
  std::function<unsigned(const Point<3>& x)> label; ///< 0 air, 1 chest, 2 fat, 3 gland

  /// Voxels of about `spacing` mm, centred at the origin and turned by `axes`.
  image::LabelImage image(double spacing, const Tensor<2, 3>& axes) const;
};

Shape ordinary_breast();  ///< a Gaussian of 60 mm over a layer of 8 mm, 0.45 l
Shape flat_breast();      ///< 18 mm high and 140 mm wide: a thin breast, supine
Shape pendulous_breast(); ///< a ball 76 mm wide on a neck of 52 mm

/// Changes of a shape.
Shape with_gland(Shape shape);       ///< a ball of gland in its middle
Shape with_far_lump(Shape shape);    ///< a second component in the air before it
Shape with_holes(Shape shape);       ///< air inside
Shape with_thin_bridge(Shape shape); ///< the lump again, on a bridge one voxel thin
Shape cut_on_all_sides(Shape shape); ///< an image so small that the mask touches all its faces

} // namespace prosup::benchmarks

#endif
