#include "force_record.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "prosup/fdm/trilinear_cell.h"

namespace prosup::fdm {

namespace {

/// The field with the value f(X) at x = X + u(X). Points between those of the grid are
/// moved too, so many that stretch leaves no point of `target` without a value.
std::vector<Tensor<1, 3>> pushed_forward(const VectorField& force, const VectorField& displacement,
                                         const image::VoxelGrid& target) {
  std::vector<Tensor<1, 3>> result(target.n_voxels());
  std::vector<double> weights(target.n_voxels(), 0.);
  const image::VoxelGrid& grid = force.grid;
  constexpr double largest_stretch = 2.;
  const unsigned n_cuts =
      unsigned(std::ceil(largest_stretch * grid.spacing[0] / target.spacing[0]));
  for (std::size_t k = 0; k < n_cuts * (grid.size[2] - 1); ++k)
    for (std::size_t j = 0; j < n_cuts * (grid.size[1] - 1); ++j)
      for (std::size_t i = 0; i < n_cuts * (grid.size[0] - 1); ++i) {
        const Point<3> X = grid.physical((double(i) + 0.5) / n_cuts, (double(j) + 0.5) / n_cuts,
                                         (double(k) + 0.5) / n_cuts);
        const Tensor<1, 3> value = force.value(X);
        const TrilinearCell cell(target, X + displacement.value(X));
        for (unsigned corner = 0; corner < 8; ++corner) {
          result[cell.node(corner)] += cell.weight(corner) * value;
          weights[cell.node(corner)] += cell.weight(corner);
        }
      }
  for (std::size_t node = 0; node < result.size(); ++node)
    if (weights[node] > 0.)
      result[node] /= weights[node];
  return result;
}

} // namespace

void ForceRecord::add(const VectorField& force, const VectorField& displacement, double time,
                      double ramp_time, const LoadedMaps& maps) {
  Field sum = sum_ ? *sum_ : Field(maps.grid().n_voxels());
  if (increment_)
    for (std::size_t node = 0; node < sum.size(); ++node)
      sum[node] += (*increment_)[node];
  sum_ = std::make_shared<const Field>(std::move(sum));
  increment_ = std::make_shared<const Field>(pushed_forward(force, displacement, maps.grid()));
  ramp_start_ = time;
  ramp_time_ = ramp_time;
  part_ = -1.;
}

bool ForceRecord::update(double time, LoadedMaps& maps) {
  const double part = ramp_time_ > 0. ? std::min(1., (time - ramp_start_) / ramp_time_) : 1.;
  if (part != part_)
    for (std::size_t node = 0; node < maps.grid().n_voxels(); ++node)
      maps.set_force(node,
                     increment_ ? (*sum_)[node] + part * (*increment_)[node] : Tensor<1, 3>());
  part_ = part;
  return part == 1.;
}

} // namespace prosup::fdm
