#include "nifti_transforms.h"

#include <algorithm>
#include <cmath>

namespace prosup::image {

namespace {

constexpr double to_lps[3] = {-1., -1., 1.}; // NIfTI's coordinates are RAS

/// Rotation of the unit quaternion a, b, c, d with a >= 0, as nifti1.h has it.
Tensor<2, 3> rotation(const std::array<double, 3>& bcd) {
  auto [b, c, d] = bcd;
  const double square = b * b + c * c + d * d;
  if (square > 1.) // by rounding: half a turn
    for (double* part : {&b, &c, &d})
      *part /= std::sqrt(square);
  const double a = square < 1. ? std::sqrt(1. - square) : 0.;
  return Tensor<2, 3>(
      {{a * a + b * b - c * c - d * d, 2. * (b * c - a * d), 2. * (b * d + a * c)},
       {2. * (b * c + a * d), a * a + c * c - b * b - d * d, 2. * (c * d - a * b)},
       {2. * (b * d - a * c), 2. * (c * d + a * b), a * a + d * d - b * b - c * c}});
}

} // namespace

bool is_size(double size) {
  return std::isfinite(size) && size != 0.;
}

std::optional<VoxelSteps> qform(const NiftiHeader& header) {
  constexpr double longest_quaternion = 1.01;
  const auto& [b, c, d] = header.quaternion;
  if (header.qform_code <= 0 || !(b * b + c * c + d * d <= longest_quaternion) ||
      !std::all_of(header.pixdim.begin(), header.pixdim.end(), is_size))
    return {};
  const Tensor<2, 3> turn = rotation(header.quaternion);
  VoxelSteps place;
  for (unsigned row = 0; row < 3; ++row) {
    if (!std::isfinite(header.qoffset[row]))
      return {};
    const double scale = to_lps[row] * header.millimetres;
    place.origin[row] = scale * header.qoffset[row];
    for (unsigned axis = 0; axis < 3; ++axis)
      place.steps[axis][row] =
          scale * turn[row][axis] * std::abs(header.pixdim[axis]) * (axis == 2 ? header.qfac : 1.);
  }
  return place;
}

std::optional<VoxelSteps> sform(const NiftiHeader& header) {
  if (header.sform_code <= 0)
    return {};
  VoxelSteps place;
  for (unsigned row = 0; row < 3; ++row) {
    const double scale = to_lps[row] * header.millimetres;
    place.origin[row] = scale * header.sform[row][3];
    for (unsigned axis = 0; axis < 3; ++axis)
      place.steps[axis][row] = scale * header.sform[row][axis];
    if (!std::isfinite(place.origin[row]))
      return {};
  }
  for (const Tensor<1, 3>& step : place.steps)
    if (!is_size(step.norm()))
      return {};
  return place;
}

Distance distance(const VoxelSteps& place, const VoxelGrid& from) {
  Distance largest;
  for (unsigned corner = 0; corner < 8; ++corner) {
    std::array<double, 3> index{};
    for (unsigned d = 0; d < 3; ++d)
      index[d] = (corner >> d & 1u) != 0 ? double(from.size[d] - 1) : 0.;
    const Point<3> seen = place.physical(index);
    const Point<3> found = from.continuous_index(seen);
    for (unsigned d = 0; d < 3; ++d)
      largest.voxels = std::max(largest.voxels, std::abs(found[d] - index[d]));
    largest.mm = std::max(largest.mm, seen.distance(from.physical(index[0], index[1], index[2])));
  }
  return largest;
}

} // namespace prosup::image
