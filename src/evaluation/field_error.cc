#include "prosup/evaluation/field_error.h"

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <limits>

#include "prosup/core/error.h"
#include "prosup/image/sampling.h"

namespace prosup::evaluation {

using namespace dealii;

namespace {

/// One component of a vector image.
image::ScalarImage component(const image::VectorImage& field, unsigned d) {
  image::ScalarImage result(field.grid);
  std::transform(field.values.begin(), field.values.end(), result.values.begin(),
                 [d](const std::array<float, 3>& value) { return value[d]; });
  return result;
}

/// F = 1 + grad d at a voxel that has neighbours on all sides.
Tensor<2, 3> gradient(const image::VectorImage& field, std::array<std::size_t, 3> at) {
  const image::VoxelGrid& grid = field.grid;
  Tensor<2, 3> per_mm; // of component and grid axis
  for (unsigned axis = 0; axis < 3; ++axis) {
    std::array<std::size_t, 3> next = at, last = at;
    ++next[axis];
    --last[axis];
    const auto& after = field(next[0], next[1], next[2]);
    const auto& before = field(last[0], last[1], last[2]);
    for (unsigned d = 0; d < 3; ++d)
      per_mm[d][axis] = (double(after[d]) - double(before[d])) / (2. * grid.spacing[axis]);
  }
  // Grid axes are the columns of the direction matrix, an orthonormal one.
  return Tensor<2, 3>(unit_symmetric_tensor<3>()) + per_mm * transpose(grid.direction);
}

} // namespace

ErrorStatistics field_error(const std::vector<Landmark>& landmarks,
                            const image::VectorImage& prone_to_supine) {
  std::vector<Point<3>> carried;
  for (const Landmark& landmark : landmarks)
    carried.push_back(landmark.prone);
  for (unsigned d = 0; d < 3; ++d) {
    const image::ScalarImage values = component(prone_to_supine, d);
    const image::BasicSampler<double> sampler(values);
    for (std::size_t i = 0; i < landmarks.size(); ++i)
      carried[i][d] += sampler.value(landmarks[i].prone);
  }
  std::vector<double> distances;
  for (std::size_t i = 0; i < landmarks.size(); ++i)
    distances.push_back(carried[i].distance(landmarks[i].supine));
  return statistics(std::move(distances));
}

FieldJacobian field_jacobian(const image::VectorImage& displacement,
                             const image::LabelImage& mask) {
  if (!displacement.grid.coincides_with(mask.grid))
    throw Error("A displacement field is not on the voxels of its mask; its Jacobian is taken on "
                "the grid of the prone image.");
  const std::array<std::size_t, 3>& size = mask.grid.size;
  FieldJacobian result;
  result.min = std::numeric_limits<double>::max();
  std::size_t n = 0, n_folded = 0;
  for (std::size_t k = 1; k + 1 < size[2]; ++k)
    for (std::size_t j = 1; j + 1 < size[1]; ++j)
      for (std::size_t i = 1; i + 1 < size[0]; ++i) {
        if (mask(i, j, k) == 0)
          continue;
        const double jacobian = determinant(gradient(displacement, {i, j, k}));
        result.min = std::min(result.min, jacobian);
        n_folded += jacobian <= 0. ? 1 : 0;
        ++n;
      }
  if (n == 0)
    throw Error("The mask of the breast has no voxel inside its grid; the Jacobian of a map cannot "
                "be taken.");
  result.folded_fraction = static_cast<double>(n_folded) / static_cast<double>(n);
  return result;
}

} // namespace prosup::evaluation
