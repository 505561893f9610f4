#ifndef PROSUP_SRC_SIMILARITY_WINDOW_SUM_H
#define PROSUP_SRC_SIMILARITY_WINDOW_SUM_H

#include <array>
#include <cstddef>
#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::similarity {

using Field = std::vector<float>; ///< a number for each voxel

/// Sums over cubic windows, by running sums along one axis after the other, so
/// that the time does not depend on the width. Windows end at the border of the
/// grid. Its own adjoint.
class WindowSum {
public:
  /// Windows reach `radius` mm to either side, rounded to voxels, at least one.
  WindowSum(const image::VoxelGrid& grid, double radius);

  /// Puts in the place of each value the sum over the window around it.
  void apply(Field& field);

private:
  void along_rows(const float* in, float* out) const;
  void along_lines(const float* in, float* out, std::size_t axis, std::size_t width);

  std::array<std::size_t, 3> size_, radius_;
  Field other_;
  std::vector<double> running_;
};

} // namespace prosup::similarity

#endif
