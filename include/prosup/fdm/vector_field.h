#ifndef PROSUP_FDM_VECTOR_FIELD_H
#define PROSUP_FDM_VECTOR_FIELD_H

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::fdm {

using dealii::Point;
using dealii::Tensor;

/// Vectors at the points of a regular grid with axes along LPS: displacements u
/// in mm, or force densities in g/(mm^2 s^2).
struct VectorField {
  image::VoxelGrid grid;
  std::vector<Tensor<1, 3>> values; ///< x fastest

  /// Trilinear interpolation; beyond the grid the value at the nearest point of it.
  Tensor<1, 3> value(const Point<3>& position) const;
};

} // namespace prosup::fdm

#endif
