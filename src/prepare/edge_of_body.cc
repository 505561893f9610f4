#include "edge_of_body.h"

// A macro of deal.II, which the precompiled header brings, and a function of ITK's statistics.
#undef Assert

#include <itkGradientMagnitudeImageFilter.h>
#include <itkMorphologicalWatershedFromMarkersImageFilter.h>

#include <algorithm>
#include <cmath>

#include "boxes.h"
#include "flood.h"
#include "image/itk_bridge.h"
#include "prosup/image/filters.h"

namespace prosup::prepare {

namespace {

using image::LabelImage;
using image::ScalarImage;
using Levels = image::VoxelImage<std::uint16_t>;

constexpr double edge = 2.;           // mm, of the voxels
constexpr double marker_blur = 2.;    // mm
constexpr double gradient_blur = 1.5; // mm
constexpr double far_radius = 25.;    // mm
constexpr double thin = 4.;           // mm, half of the thickness of what may be no tissue
constexpr double sure = 1.5;          // thresholds
constexpr double share_of_peak = 0.15;
constexpr double levels_per_unit = 1e4; // of the gradient of the logarithm, 1/mm
constexpr std::uint8_t air = 1, tissue = 2;

/// `air` and `tissue` where they are sure, 0 elsewhere.
LabelImage sure_parts(const ScalarImage& coarse, double threshold) {
  const ScalarImage smooth = image::gaussian_smooth(coarse, marker_blur);
  const ScalarImage peak = local_peak(smooth, far_radius);
  LabelImage dark(coarse.grid), bright(coarse.grid);
  for (std::size_t v = 0; v < dark.values.size(); ++v) {
    const double value = double(smooth.values[v]);
    dark.values[v] = value < threshold;
    bright.values[v] = value > sure * threshold && value > share_of_peak * double(peak.values[v]);
  }
  LabelImage parts = eroded(seen_from_front(dark), edge);
  const LabelImage thick = image::largest_component(opened(bright, thin));
  for (std::size_t v = 0; v < parts.values.size(); ++v)
    if (thick.values[v] != 0)
      parts.values[v] = tissue;
  return parts;
}

/// The magnitude of the gradient of log(I + threshold / 2).
Levels gradient_of_log(const ScalarImage& coarse, double threshold) {
  using Itk = image::ItkImage<float>;
  ScalarImage logarithm = image::gaussian_smooth(coarse, gradient_blur);
  const double offset = std::max(0.5 * threshold, 1e-6); // 0 in an image of zeros
  for (float& value : logarithm.values)
    value = float(std::log(std::max(double(value), 0.) + offset));
  auto gradient = itk::GradientMagnitudeImageFilter<Itk, Itk>::New();
  gradient->SetInput(image::as_itk(logarithm));
  gradient->Update();
  const float* magnitude = gradient->GetOutput()->GetBufferPointer();
  Levels levels(coarse.grid);
  for (std::size_t v = 0; v < levels.values.size(); ++v)
    levels.values[v] = std::uint16_t(std::min(levels_per_unit * double(magnitude[v]), 65535.));
  return levels;
}

} // namespace

LabelImage body_within_edges(const ScalarImage& image, double threshold) {
  const ScalarImage coarse = image::resample_isotropic(image, edge);
  const LabelImage markers = sure_parts(coarse, threshold);
  const Levels levels = gradient_of_log(coarse, threshold);
  using Labels = image::ItkImage<std::uint8_t>;
  auto watershed = itk::MorphologicalWatershedFromMarkersImageFilter<image::ItkImage<std::uint16_t>,
                                                                     Labels>::New();
  watershed->SetInput(image::as_itk(levels));
  watershed->SetMarkerImage(image::as_itk(markers));
  watershed->SetMarkWatershedLine(false);
  watershed->Update();
  const LabelImage parts = image::from_itk<std::uint8_t>(*watershed->GetOutput(), coarse.grid);
  return image::select_labels(eroded(image::select_labels(parts, {air}), edge), {0});
}

} // namespace prosup::prepare
