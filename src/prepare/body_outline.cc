#include "prosup/prepare/body_outline.h"

// A macro of deal.II, which the precompiled header brings, and a function of ITK's statistics.
#undef Assert

#include <itkOtsuThresholdImageFilter.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "boxes.h"
#include "edge_of_body.h"
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

constexpr double blur = 0.7;                   // mm, against noise
constexpr double peak_radius = 2.;             // mm
constexpr double wide_radius = 8.;             // mm
constexpr double far_radius = 25.;             // mm
constexpr double wide_edge = 3.;               // mm, of the voxels for the wide peak
constexpr double notch = 3.;                   // mm, half of the width of what is closed
constexpr double skin_depth = 4.;              // mm
constexpr double gap = 5.;                     // mm, of outlines with holes
constexpr double skin = 2.;                    // mm
constexpr double fat_begin = 4., fat_end = 8.; // mm below the air
constexpr double bright_skin = 1.35;           // of the fat below it
constexpr double undercut = 40.;               // mm
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

dealii::Point<3> position_of(std::size_t voxel, const image::VoxelGrid& grid) {
  const std::size_t n = grid.size[0], m = grid.size[1];
  return grid.physical(double(voxel % n), double(voxel / n % m), double(voxel / (n * m)));
}

/// Largest intensities in boxes that are wide enough for coarse voxels.
class WidePeak {
public:
  WidePeak(const ScalarImage& smooth, double radius)
      : grid_(smooth.grid), peak_(local_peak(image::resample_isotropic(smooth, wide_edge), radius)),
        sampler_(peak_) {}

  float operator()(std::size_t voxel) const { return sampler_.value(position_of(voxel, grid_)); }

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
  const LabelImage inside = body_within_edges(smooth, threshold);
  return where(smooth, [&](std::size_t v) {
    return above(v) && smooth.values[v] > tenth * peak(v) &&
           image::nearest_label(inside, position_of(v, smooth.grid)) != 0;
  });
}

/// Peaks of the tissue nearby, against which the edge of the skin is found.
struct SkinPeaks {
  explicit SkinPeaks(const ScalarImage& smooth)
      : near(local_peak(smooth, peak_radius)), wide(smooth, wide_radius) {}
  const ScalarImage near;
  const WidePeak wide;
};

/// 1 where the intensity is below a share of the peak nearby or a quarter of that in a wider box.
LabelImage below_peaks(const ScalarImage& smooth, const SkinPeaks& peaks, float share) {
  return where(smooth, [&](std::size_t v) {
    return smooth.values[v] <= share * peaks.near.values[v] ||
           smooth.values[v] <= quarter * peaks.wide(v);
  });
}

/// Median of an image from `begin` to `end` mm below the air.
double median_below(const ScalarImage& image, const LabelImage& air, double begin, double end) {
  const LabelImage all(air.grid, 1);
  LabelImage above = air, layer = air;
  flood(above, all, begin);
  flood(layer, all, end);
  std::vector<float> values;
  for (std::size_t v = 0; v < layer.values.size(); ++v)
    if (layer.values[v] != 0 && above.values[v] == 0)
      values.push_back(image.values[v]);
  return values.empty() ? 0. : double(quantile(std::move(values), 0.5));
}

/// Extends the air to the middle of the skin's edge in MR. The peak there is that of the skin, or
/// that of fat if fat is brighter; then skin is about half as bright as fat.
void extend_to_skin(LabelImage& air, const ScalarImage& smooth) {
  const SkinPeaks peaks(smooth);
  LabelImage to_half = air;
  flood(to_half, below_peaks(smooth, peaks, half), skin_depth);
  if (median_below(peaks.near, to_half, 0., skin) >
      bright_skin * median_below(smooth, to_half, fat_begin, fat_end))
    air = std::move(to_half);
  else
    flood(air, below_peaks(smooth, peaks, quarter), skin_depth);
}

double median_of_air(const ScalarImage& image, const LabelImage& air) {
  std::vector<float> values;
  for (std::size_t v = 0; v < air.values.size(); ++v)
    if (air.values[v] != 0 && image.values[v] != 0.f) // 0 is also padding
      values.push_back(image.values[v]);
  return double(quantile(std::move(values), 0.5));
}

} // namespace

Outline find_outline(const ScalarImage& image, bool is_ct) {
  const ScalarImage smooth = image::gaussian_smooth(image, blur);
  Outline outline;
  outline.threshold = is_ct ? ct_threshold : noise_threshold(smooth);
  const LabelImage solid = image::largest_component(solid_parts(smooth, outline.threshold, is_ct));
  LabelImage air = air_in_front(image::select_labels(solid, {0}));
  if (!is_ct)
    extend_to_skin(air, smooth);
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
