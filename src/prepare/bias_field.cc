#include "prosup/prepare/bias_field.h"

#include <itkN4BiasFieldCorrectionImageFilter.h>

#include <algorithm>

#include "image/itk_bridge.h"
#include "prosup/core/error.h"
#include "prosup/image/filters.h"
#include "prosup/image/sampling.h"

namespace prosup::prepare {

namespace {

using image::LabelImage;
using image::ScalarImage;
using Itk = image::ItkImage<float>;
using ItkMask = image::ItkImage<std::uint8_t>;

constexpr double coarse_edge = 6.; // mm

LabelImage tissue_on(const ScalarImage& coarse, const LabelImage& body, double threshold) {
  LabelImage mask(coarse.grid);
  const auto& size = coarse.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i)
        mask(i, j, k) =
            double(coarse(i, j, k)) > threshold &&
            image::nearest_label(body, coarse.grid.physical(double(i), double(j), double(k))) != 0;
  return mask;
}

/// The quotient of a coarse image and the same without bias.
ScalarImage coarse_field(const ScalarImage& coarse, const LabelImage& tissue) {
  using N4 = itk::N4BiasFieldCorrectionImageFilter<Itk, ItkMask, Itk>;
  auto n4 = N4::New();
  n4->SetInput(image::as_itk(coarse));
  n4->SetMaskImage(image::as_itk(tissue));
  N4::VariableSizeArrayType iterations(3);
  iterations.Fill(25);
  n4->SetNumberOfFittingLevels(3);
  n4->SetMaximumNumberOfIterations(iterations);
  n4->SetConvergenceThreshold(1e-3);
  n4->Update();
  const ScalarImage corrected = image::from_itk<float>(*n4->GetOutput(), coarse.grid);
  ScalarImage field(coarse.grid, 1.f);
  for (std::size_t v = 0; v < field.values.size(); ++v)
    if (tissue.values[v] != 0 && corrected.values[v] > 0.f)
      field.values[v] = coarse.values[v] / corrected.values[v];
  return field;
}

/// Continues a field smoothly where it is not known: averages over ever wider neighbourhoods.
ScalarImage continued(const ScalarImage& field, const LabelImage& known) {
  ScalarImage result = field;
  LabelImage done = known;
  for (double width = coarse_edge; width < 200.; width *= 2.) {
    ScalarImage sum(field.grid), weight(field.grid);
    for (std::size_t v = 0; v < known.values.size(); ++v)
      if (known.values[v] != 0) {
        sum.values[v] = field.values[v];
        weight.values[v] = 1.f;
      }
    sum = image::gaussian_smooth(sum, width);
    weight = image::gaussian_smooth(weight, width);
    for (std::size_t v = 0; v < known.values.size(); ++v)
      if (done.values[v] == 0 && weight.values[v] > 1e-2f) {
        result.values[v] = sum.values[v] / weight.values[v];
        done.values[v] = 1;
      }
  }
  return result;
}

} // namespace

ScalarImage without_bias(const ScalarImage& image, const LabelImage& body, double threshold) {
  ScalarImage coarse = image::resample_isotropic(image, coarse_edge);
  for (float& value : coarse.values)
    value = std::max(value, 0.f);
  const LabelImage tissue = tissue_on(coarse, body, threshold);
  if (std::count(tissue.values.begin(), tissue.values.end(), 1) == 0)
    throw Error("The bias field cannot be found because no tissue is brighter than the noise; set "
                "'Preparation/Bias correction' to none.");
  const ScalarImage field = continued(coarse_field(coarse, tissue), tissue);
  const image::Sampler sampler(field);
  ScalarImage corrected(image.grid);
  std::size_t voxel = 0;
  const auto& size = image.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i, ++voxel)
        corrected.values[voxel] =
            image.values[voxel] /
            std::max(sampler.value(image.grid.physical(double(i), double(j), double(k))), 0.05f);
  return corrected;
}

} // namespace prosup::prepare
