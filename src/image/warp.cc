#include "prosup/image/warp.h"

#include <itkBSplineInterpolateImageFunction.h>
#include <itkNearestNeighborInterpolateImageFunction.h>
#include <itkWarpImageFilter.h>

#include <algorithm>
#include <cmath>

#include "itk_bridge.h"
#include "prosup/core/error.h"
#include "prosup/core/text.h"
#include "prosup/image/filters.h"

namespace prosup::image {

namespace {

using Itk = ItkImage<float>;
using ItkField = ItkImage<std::array<float, 3>>;
using Interpolator = itk::InterpolateImageFunction<Itk, double>;

Interpolator::Pointer interpolator(Interpolation interpolation) {
  if (interpolation == Interpolation::nearest)
    return itk::NearestNeighborInterpolateImageFunction<Itk, double>::New().GetPointer();
  return itk::BSplineInterpolateImageFunction<Itk, double>::New().GetPointer();
}

} // namespace

const std::vector<std::string>& interpolation_names() {
  static const std::vector<std::string> names{"linear", "nearest", "bspline"};
  return names;
}

Interpolation interpolation_of(const std::string& name) {
  const auto& names = interpolation_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error("The interpolation '" + name + "' is not known; choose one of " + joined(names) +
                ".");
  return static_cast<Interpolation>(found - names.begin());
}

ScalarImage warp(const ScalarImage& image, const VectorImage& displacement,
                 Interpolation interpolation, float outside) {
  if (interpolation == Interpolation::linear)
    return warp(image, displacement, outside);
  using Filter = itk::WarpImageFilter<Itk, Itk, ItkField>;
  const auto input = as_itk(image);
  const auto field = as_itk(displacement);
  auto filter = Filter::New();
  filter->SetInput(input);
  filter->SetDisplacementField(field);
  filter->SetOutputParametersFromImage(field);
  filter->SetInterpolator(interpolator(interpolation));
  filter->SetEdgePaddingValue(outside);
  filter->Update();
  return from_itk<float>(*filter->GetOutput(), displacement.grid);
}

FieldSampler::FieldSampler(const VectorImage& field, const RigidTransform& beyond)
    : field_(field), beyond_(beyond) {}

Tensor<1, 3> FieldSampler::operator()(const Point<3>& point) const {
  const VoxelGrid& grid = field_.grid;
  const Point<3> index = grid.continuous_index(point);
  std::array<std::size_t, 3> first{};
  Tensor<1, 3> t;
  constexpr double rounding = 1e-6; // voxels
  for (unsigned d = 0; d < 3; ++d) {
    const double last = double(grid.size[d]) - 1.;
    if (!(index[d] >= -rounding && index[d] <= last + rounding))
      return beyond_(point) - point;
    const double within = std::clamp(index[d], 0., last);
    first[d] = static_cast<std::size_t>(std::min(within, std::max(last - 1., 0.)));
    t[d] = within - double(first[d]);
  }
  Tensor<1, 3> u;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double weight = 1.;
    std::array<std::size_t, 3> at = first;
    for (unsigned d = 0; d < 3; ++d) {
      const bool upper = (corner >> d & 1u) != 0;
      weight *= upper ? t[d] : 1. - t[d];
      at[d] = std::min(first[d] + (upper ? 1 : 0), grid.size[d] - 1);
    }
    const auto& value = field_(at[0], at[1], at[2]);
    for (unsigned d = 0; d < 3; ++d)
      u[d] += weight * double(value[d]);
  }
  return u;
}

VectorImage resampled(const VectorImage& field, const VoxelGrid& grid,
                      const RigidTransform& beyond) {
  const FieldSampler sampler(field, beyond);
  VectorImage result(grid);
  std::size_t v = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i, ++v) {
        const Tensor<1, 3> u = sampler(grid.physical(double(i), double(j), double(k)));
        for (unsigned d = 0; d < 3; ++d)
          result.values[v][d] = static_cast<float>(u[d]);
      }
  return result;
}

} // namespace prosup::image
