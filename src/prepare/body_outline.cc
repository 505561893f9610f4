#include "prosup/prepare/body_outline.h"

// A macro of deal.II, which the precompiled header brings, and a function of ITK's statistics.
#undef Assert

#include <itkFlatStructuringElement.h>
#include <itkGrayscaleDilateImageFilter.h>
#include <itkGrayscaleErodeImageFilter.h>
#include <itkOtsuThresholdImageFilter.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "flood.h"
#include "image/itk_bridge.h"
#include "prosup/core/error.h"
#include "prosup/core/quantile.h"
#include "prosup/image/filters.h"
#include "prosup/image/sampling.h"

namespace prosup::prepare {

namespace {

using image::LabelImage;
using image::ScalarImage;
using Itk = image::ItkImage<float>;

constexpr double blur = 0.7;       // mm, against noise
constexpr double peak_radius = 2.; // mm
constexpr double wide_radius = 8.; // mm
constexpr double far_radius = 25.; // mm
constexpr double wide_edge = 3.;   // mm, of the voxels for the wide peak
constexpr double notch = 3.;       // mm, half of the width of what is closed
constexpr double skin_depth = 4.;  // mm
constexpr double gap = 5.;         // mm, of outlines with holes
constexpr double undercut = 40.;   // mm
constexpr float half = 0.5f, quarter = 0.25f, tenth = 0.1f;
constexpr double ct_threshold = -500.;

/// Otsu's threshold of log(1 + intensity), as an intensity.
double noise_threshold(const ScalarImage& image) {
  ScalarImage logarithm(image.grid);
  std::transform(image.values.begin(), image.values.end(), logarithm.values.begin(),
                 [](float value) { return std::log1p(std::max(value, 0.f)); });
  auto otsu = itk::OtsuThresholdImageFilter<Itk, image::ItkImage<std::uint8_t>>::New();
  otsu->SetInput(image::as_itk(logarithm));
  otsu->SetNumberOfHistogramBins(256);
  otsu->Update();
  return std::expm1(double(otsu->GetThreshold()));
}

using Box = itk::FlatStructuringElement<3>;

/// A box that reaches `radius` mm from its centre.
Box box(const image::VoxelGrid& grid, double radius) {
  Box::RadiusType n_voxels;
  for (unsigned d = 0; d < 3; ++d)
    n_voxels[d] = static_cast<unsigned long>(std::lround(radius / grid.spacing[d]));
  return Box::Box(n_voxels);
}

/// Largest intensity in a box that reaches `radius` mm from each voxel.
ScalarImage local_peak(const ScalarImage& image, double radius) {
  auto dilate = itk::GrayscaleDilateImageFilter<Itk, Itk, Box>::New();
  dilate->SetInput(image::as_itk(image));
  dilate->SetKernel(box(image.grid, radius));
  dilate->Update();
  return image::from_itk<float>(*dilate->GetOutput(), image.grid);
}

/// 1 where a straight line from the front face of the image meets nothing that is not `passable`.
LabelImage seen_from_front(const LabelImage& passable) {
  LabelImage seen(passable.grid);
  const auto& size = seen.grid.size;
  const bool forward = front_is_first(seen.grid);
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t i = 0; i < size[0]; ++i)
      for (std::size_t n = 0; n < size[1]; ++n) {
        const std::size_t j = forward ? n : size[1] - 1 - n;
        if (passable(i, j, k) == 0)
          break;
        seen(i, j, k) = 1;
      }
  return seen;
}

/// The mask without what is nearer than `radius` mm to its outside, in boxes.
LabelImage eroded(const LabelImage& mask, double radius) {
  using Image = image::ItkImage<std::uint8_t>;
  auto erode = itk::GrayscaleErodeImageFilter<Image, Image, Box>::New();
  erode->SetInput(image::as_itk(mask));
  erode->SetKernel(box(mask.grid, radius));
  erode->Update();
  return image::from_itk<std::uint8_t>(*erode->GetOutput(), mask.grid);
}

/// The mask with notches filled that are narrower than a box of `radius` mm.
LabelImage closed(const LabelImage& mask, double radius) {
  const LabelImage outside = image::select_labels(mask, {0});
  const LabelImage dilated = image::select_labels(eroded(outside, radius), {0});
  return eroded(dilated, radius);
}

/// The part of `open` that belongs to the air in front: what is seen from the front, and what lies
/// beside that, through passages wider than a gap in the outline.
LabelImage air_in_front(const LabelImage& open) {
  const LabelImage wide = eroded(open, gap);
  LabelImage air = seen_from_front(wide);
  flood(air, wide, undercut);
  flood(air, open, 4. * gap); // around the corners of boxes
  return air;
}

template <typename Predicate>
LabelImage where(const ScalarImage& image, const Predicate& predicate) {
  LabelImage mask(image.grid);
  for (std::size_t v = 0; v < mask.values.size(); ++v)
    mask.values[v] = predicate(v) ? 1 : 0;
  return mask;
}

/// Largest intensities in boxes that are wide enough for coarse voxels.
class WidePeak {
public:
  WidePeak(const ScalarImage& smooth, double radius)
      : grid_(smooth.grid), peak_(local_peak(image::resample_isotropic(smooth, wide_edge), radius)),
        sampler_(peak_) {}

  float operator()(std::size_t voxel) const {
    const std::size_t n = grid_.size[0], m = grid_.size[1];
    return sampler_.value(
        grid_.physical(double(voxel % n), double(voxel / n % m), double(voxel / (n * m))));
  }

private:
  const image::VoxelGrid& grid_;
  const ScalarImage peak_;
  const image::Sampler sampler_;
};

/// 1 where there is more than noise and ghosts.
LabelImage solid_parts(const ScalarImage& smooth, double threshold, bool is_ct) {
  const auto above = [&](std::size_t v) { return double(smooth.values[v]) > threshold; };
  if (is_ct)
    return where(smooth, above);
  const WidePeak peak(smooth, far_radius);
  return where(smooth,
               [&](std::size_t v) { return above(v) && smooth.values[v] > tenth * peak(v); });
}

/// 1 where the intensity is below half of the peak nearby or a quarter of that in a wider box.
LabelImage below_peaks(const ScalarImage& smooth) {
  const ScalarImage peak = local_peak(smooth, peak_radius);
  const WidePeak wide_peak(smooth, wide_radius);
  return where(smooth, [&](std::size_t v) {
    return smooth.values[v] <= half * peak.values[v] || smooth.values[v] <= quarter * wide_peak(v);
  });
}

double median_of_air(const ScalarImage& image, const LabelImage& air) {
  std::vector<float> values;
  for (std::size_t v = 0; v < air.values.size(); ++v)
    if (air.values[v] != 0 && image.values[v] != 0.f) // 0 is also padding
      values.push_back(image.values[v]);
  return double(quantile(std::move(values), 0.5));
}

} // namespace

bool front_is_first(const image::VoxelGrid& grid) {
  return grid.direction[1][1] > 0.;
}

Outline find_outline(const ScalarImage& image, bool is_ct) {
  const ScalarImage smooth = image::gaussian_smooth(image, blur);
  Outline outline;
  outline.threshold = is_ct ? ct_threshold : noise_threshold(smooth);
  const LabelImage solid = image::largest_component(solid_parts(smooth, outline.threshold, is_ct));
  LabelImage open = image::select_labels(solid, {0});
  LabelImage air = air_in_front(open);
  if (!is_ct) {
    open = below_peaks(smooth);
    flood(air, open, skin_depth);
  }
  const LabelImage body = image::largest_component(closed(image::select_labels(air, {0}), notch));
  const auto n_body = std::count(body.values.begin(), body.values.end(), 1);
  if (n_body == 0 || std::size_t(n_body) == body.values.size())
    throw Error("No outline of a body is found, because the image has no air in front of it or "
                "shows nothing but noise; give a scan of the chest with air in front.");
  outline.body = body;
  outline.air = median_of_air(image, air);
  return outline;
}

} // namespace prosup::prepare
