#include <itkEuler3DTransform.h>
#include <itkMattesMutualInformationImageToImageMetricv4.h>
#include <itkPowellOptimizerv4.h>
#include <itkTranslationTransform.h>

#include <algorithm>
#include <cmath>

#include "itk_bridge.h"
#include "prosup/core/error.h"
#include "prosup/image/filters.h"
#include "prosup/image/rigid_alignment.h"
#include "prosup/image/sampling.h"

namespace prosup::image {

using namespace dealii;

namespace {

constexpr std::size_t n_points_needed = 2000;
constexpr unsigned n_bins = 40;
constexpr unsigned n_work_units = 4; // fixed: the order of sums decides the last digits
constexpr double tolerance = 0.01;   // mm
constexpr double value_tolerance = 1e-6;
constexpr unsigned n_iterations = 20;
constexpr double fine_sigma = 0.7; // of the smoothing where voxels stay as they are, voxels
// Space is measured in this length, so that 1 rad weighs as much as 1 translation.
constexpr double lever = 50.; // mm

/// One step from coarse to fine.
struct Level {
  double edge;          ///< of the voxels, mm
  std::size_t n_points; ///< at which the images are compared
  double first_step;    ///< of the search, mm
};
constexpr Level levels[] = {{4., 20000, 2.}, {2., 50000, 1.}, {1., 100000, 0.5}};

double fraction(double x) {
  return x - std::floor(x);
}

/// Points spread evenly over the voxels of a mask and inside them, the same each
/// time. Off the grid, since mutual information has false maxima where two grids
/// coincide.
std::vector<Point<3>> points_in(const LabelImage& mask, std::size_t n_wanted) {
  std::vector<std::size_t> inside;
  for (std::size_t v = 0; v < mask.values.size(); ++v)
    if (mask.values[v] != 0)
      inside.push_back(v);
  const std::size_t n = std::min(n_wanted, inside.size());
  const auto& size = mask.grid.size;
  std::vector<Point<3>> points;
  for (std::size_t p = 0; p < n; ++p) {
    const std::size_t v = inside[p * inside.size() / n];
    double index[3] = {double(v % size[0]), double(v / size[0] % size[1]),
                       double(v / (size[0] * size[1]))};
    // Additive recurrence of low discrepancy in three dimensions.
    constexpr double step[3] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
    for (unsigned d = 0; d < 3; ++d)
      index[d] += fraction(0.5 + double(p) * step[d]) - 0.5;
    points.push_back(mask.grid.physical(index[0], index[1], index[2]));
  }
  if (n < n_points_needed)
    throw Error("The chest walls cannot be aligned by intensities because there is hardly any "
                "chest wall in a label image; check the labels and 'Meshing/Chest label', or set "
                "'Pre-alignment/Method' to none.");
  return points;
}

/// The image clamped to what occurs at the points: elsewhere it may hold extremes
/// that would leave few bins for the chest.
ScalarImage clamped(const ScalarImage& image, const std::vector<Point<3>>& points) {
  VoxelGrid line;
  line.size = {points.size(), 1, 1};
  ScalarImage at_points(line);
  const Sampler sampler(image);
  std::transform(points.begin(), points.end(), at_points.values.begin(),
                 [&](const Point<3>& p) { return sampler.value(p); });
  const IntensityRange range = robust_range(at_points, LabelImage(line, 1), 0.5, 99.5);
  ScalarImage result = image;
  for (float& value : result.values)
    value = std::clamp(value, float(range.low), float(range.high));
  return result;
}

/// The image of a level.
ScalarImage at_level(const ScalarImage& image, double edge) {
  const auto& spacing = image.grid.spacing;
  const double finest = std::min({spacing[0], spacing[1], spacing[2]});
  return edge > 1.5 * finest ? resample_isotropic(image, edge)
                             : gaussian_smooth(image, fine_sigma * edge);
}

VoxelGrid in_levers(VoxelGrid grid) {
  grid.origin = Point<3>(grid.origin / lever);
  grid.spacing /= lever;
  return grid;
}

using Metric = itk::MattesMutualInformationImageToImageMetricv4<ItkImage<float>, ItkImage<float>>;

Metric::Pointer make_metric(const ScalarImage& target, const ScalarImage& source,
                            const std::vector<Point<3>>& points,
                            itk::Transform<double, 3, 3>* transform) {
  auto at = Metric::FixedSampledPointSetType::New();
  for (std::size_t p = 0; p < points.size(); ++p) {
    Metric::FixedSampledPointSetType::PointType position;
    for (unsigned d = 0; d < 3; ++d)
      position[d] = points[p][d] / lever;
    at->SetPoint(p, position);
  }
  auto metric = Metric::New();
  metric->SetFixedImage(as_itk(target));
  metric->SetMovingImage(as_itk(source));
  metric->SetMovingTransform(transform);
  metric->SetFixedSampledPointSet(at);
  metric->SetUseSampledPointSet(true);
  metric->SetUseFixedImageGradientFilter(false); // values only, no gradients
  metric->SetUseMovingImageGradientFilter(false);
  metric->SetNumberOfHistogramBins(n_bins);
  metric->SetMaximumNumberOfWorkUnits(n_work_units);
  metric->Initialize();
  return metric;
}

/// Maximises the information; `metric` has the best parameters in the end.
void search(Metric& metric, double first_step) {
  auto optimizer = itk::PowellOptimizerv4<double>::New();
  optimizer->SetMetric(&metric);
  optimizer->SetStepLength(first_step / lever);
  optimizer->SetStepTolerance(tolerance / lever);
  optimizer->SetValueTolerance(value_tolerance);
  optimizer->SetMaximumIteration(n_iterations);
  optimizer->StartOptimization();
  auto best = optimizer->GetCurrentPosition();
  metric.SetParameters(best);
}

/// The way back of an ITK transform, which leads from the target to the source
/// and measures in levers.
RigidTransform back(const itk::Transform<double, 3, 3>& itk_transform, const Point<3>& centre) {
  const auto apply = [&](const Point<3>& x) {
    itk::Point<double, 3> scaled;
    for (unsigned d = 0; d < 3; ++d)
      scaled[d] = x[d] / lever;
    const auto moved = itk_transform.TransformPoint(scaled);
    return Point<3>(moved[0] * lever, moved[1] * lever, moved[2] * lever);
  };
  RigidTransform transform;
  transform.centre = centre;
  transform.translation = apply(centre) - centre;
  for (unsigned e = 0; e < 3; ++e) {
    Point<3> along = centre;
    along[e] += 1.;
    const Tensor<1, 3> column = apply(along) - apply(centre);
    for (unsigned d = 0; d < 3; ++d)
      transform.rotation[d][e] = column[d];
  }
  return transform.inverse();
}

/// What is compared at one level; the source lies where the transform found so
/// far takes it.
struct Comparison {
  const ScalarImage& target;
  ScalarImage source;
  const std::vector<Point<3>>& points;
  double first_step;
};

/// Calls `use` with the metric of a comparison for ITK's `motion`, which comes
/// after the transform found so far.
template <class Use>
void with_metric(const RigidTransform& found, const Comparison& comparison,
                 itk::Transform<double, 3, 3>* motion, const Use& use) {
  ScalarImage source = comparison.source;
  source.grid = in_levers(found(source.grid));
  ScalarImage target = comparison.target;
  target.grid = in_levers(target.grid);
  use(*make_metric(target, source, comparison.points, motion));
}

double information(const RigidTransform& found, const Comparison& comparison) {
  double value = 0.;
  with_metric(found, comparison, itk::TranslationTransform<double, 3>::New(),
              [&](Metric& metric) { value = -metric.GetValue(); });
  return value;
}

/// Improves `found` with a motion that is the identity at first.
void improve(RigidTransform& found, const Comparison& comparison,
             itk::Transform<double, 3, 3>* motion) {
  with_metric(found, comparison, motion,
              [&](Metric& metric) { search(metric, comparison.first_step); });
  found = compose(back(*motion, found.centre), found);
}

itk::Euler3DTransform<double>::Pointer motion_about(const Point<3>& centre) {
  auto euler = itk::Euler3DTransform<double>::New();
  itk::Point<double, 3> in_levers;
  for (unsigned d = 0; d < 3; ++d)
    in_levers[d] = centre[d] / lever;
  euler->SetCenter(in_levers);
  return euler;
}

} // namespace

IntensityAlignment align_intensities(const MaskedImage& target, const MaskedImage& source,
                                     const RigidTransform& start, DegreesOfFreedom freedom) {
  const std::size_t n_all = std::end(levels)[-1].n_points;
  const ScalarImage target_image = clamped(target.image, points_in(target.mask, n_all));
  const ScalarImage source_image = clamped(source.image, points_in(source.mask, n_all));
  IntensityAlignment result;
  result.transform = start;
  for (const Level& level : levels) {
    const ScalarImage target_level = at_level(target_image, level.edge);
    const auto points = points_in(target.mask, level.n_points);
    const Comparison comparison{target_level, at_level(source_image, level.edge), points,
                                level.first_step};
    // Rotations that are sought while the place is wrong lead astray.
    improve(result.transform, comparison, itk::TranslationTransform<double, 3>::New());
    if (freedom == DegreesOfFreedom::rigid)
      improve(result.transform, comparison, motion_about(start.centre));
    if (&level + 1 == std::end(levels)) {
      result.information_before = information(start, comparison);
      result.information_after = information(result.transform, comparison);
    }
  }
  return result;
}

} // namespace prosup::image
