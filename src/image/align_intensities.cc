#include <itkEuler3DTransform.h>
#include <itkMattesMutualInformationImageToImageMetricv4.h>
#include <itkPowellOptimizer.h>

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
// One: the order of sums decides the last digits, and under MPI other ranks keep the
// other cores busy.
constexpr unsigned n_work_units = 1;
constexpr double tolerance = 0.01; // mm
constexpr double value_tolerance = 1e-6;
constexpr unsigned n_iterations = 20;
constexpr double fine_sigma = 0.7; // of the smoothing where voxels stay as they are, voxels
constexpr double scan_step = 2.;   // mm
constexpr unsigned n_candidates = 3;

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
                "chest wall in a label image; check the labels and 'Labels/Chest', or set "
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

using Metric = itk::MattesMutualInformationImageToImageMetricv4<ItkImage<float>, ItkImage<float>>;

Metric::Pointer make_metric(const ScalarImage& target, const ScalarImage& source,
                            const std::vector<Point<3>>& points,
                            itk::Transform<double, 3, 3>* transform) {
  auto at = Metric::FixedSampledPointSetType::New();
  for (std::size_t p = 0; p < points.size(); ++p) {
    Metric::FixedSampledPointSetType::PointType position;
    for (unsigned d = 0; d < 3; ++d)
      position[d] = points[p][d];
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

/// Minus the information as a function of how far (mm) the source goes along the
/// open motions.
class Information : public itk::SingleValuedCostFunction {
public:
  using Self = Information;
  using Pointer = itk::SmartPointer<Self>;

  static Pointer New() {
    const Pointer made = new Self;
    made->UnRegister(); // the smart pointer holds it now
    return made;
  }

  /// Keeps the images, which the metric only refers to.
  void set_images(ScalarImage target, ScalarImage source, const std::vector<Point<3>>& points) {
    target_ = std::move(target);
    source_ = std::move(source);
    euler_ = itk::Euler3DTransform<double>::New();
    metric_ = make_metric(target_, source_, points, euler_);
  }

  void set_motions(const RigidTransform& start, const std::vector<RigidMotion>& open) {
    start_ = start;
    open_ = open;
  }

  RigidTransform transform(const ParametersType& along) const {
    RigidMotion motion;
    for (unsigned m = 0; m < open_.size(); ++m)
      motion.add(along[m], open_[m]);
    return compose(motion.about(start_(start_.centre)), start_);
  }

  MeasureType GetValue(const ParametersType& along) const override {
    // ITK's transforms lead from the target to the source.
    const RigidTransform inverse = transform(along).inverse();
    itk::Euler3DTransform<double>::OutputVectorType offset;
    itk::Matrix<double, 3, 3> matrix;
    const Point<3> at_zero = inverse(Point<3>());
    for (unsigned d = 0; d < 3; ++d) {
      offset[d] = at_zero[d];
      for (unsigned e = 0; e < 3; ++e)
        matrix(d, e) = inverse.rotation[d][e];
    }
    euler_->SetMatrix(matrix);
    euler_->SetOffset(offset);
    return metric_->GetValue();
  }

  void GetDerivative(const ParametersType&, DerivativeType&) const override {}
  unsigned GetNumberOfParameters() const override { return unsigned(open_.size()); }

private:
  ScalarImage target_, source_;
  Metric::Pointer metric_;
  itk::Euler3DTransform<double>::Pointer euler_;
  RigidTransform start_;
  std::vector<RigidMotion> open_;
};

using Along = Information::ParametersType;

/// The minimum next to `along`.
Along nearest_minimum(Information& information, const Along& along, double first_step) {
  auto optimizer = itk::PowellOptimizer::New();
  optimizer->SetCostFunction(&information);
  optimizer->SetInitialPosition(along);
  optimizer->SetStepLength(first_step);
  optimizer->SetStepTolerance(tolerance);
  optimizer->SetValueTolerance(value_tolerance);
  optimizer->SetMaximumIteration(n_iterations);
  optimizer->StartOptimization();
  return optimizer->GetCurrentPosition();
}

/// Places within the search distance, those of least value first, and each at a distance from
/// those before.
std::vector<Along> candidates(const Information& information, double search_distance) {
  std::vector<std::pair<double, Along>> places;
  const unsigned n_motions = information.GetNumberOfParameters();
  const int n = int(search_distance / scan_step), n_along = 2 * n + 1;
  const auto n_places = unsigned(std::pow(n_along, n_motions) + 0.5);
  for (unsigned place = 0; place < n_places; ++place) {
    Along along(n_motions);
    for (unsigned m = 0, rest = place; m < n_motions; ++m, rest /= unsigned(n_along))
      along[m] = scan_step * (int(rest % unsigned(n_along)) - n);
    places.emplace_back(information.GetValue(along), along);
  }
  std::sort(places.begin(), places.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Along> chosen;
  for (const auto& [value, along] : places) {
    const auto close = [&, &along = along](const Along& other) {
      return (along - other).two_norm() < 2.5 * scan_step;
    };
    if (chosen.size() < n_candidates && std::none_of(chosen.begin(), chosen.end(), close))
      chosen.push_back(along);
  }
  return chosen;
}

} // namespace

IntensityAlignment align_intensities(const MaskedImage& target, const MaskedImage& source,
                                     const RigidTransform& start,
                                     const std::vector<RigidMotion>& open, double search_distance) {
  const std::size_t n_all = std::end(levels)[-1].n_points;
  const ScalarImage target_image = clamped(target.image, points_in(target.mask, n_all));
  const ScalarImage source_image = clamped(source.image, points_in(source.mask, n_all));
  IntensityAlignment result;
  Along zero(unsigned(open.size()));
  zero.fill(0.);
  std::vector<Along> found{zero};
  double least = 0.;
  const auto information = Information::New();
  information->set_motions(start, open);
  for (const Level& level : levels) {
    information->set_images(at_level(target_image, level.edge), at_level(source_image, level.edge),
                            points_in(target.mask, level.n_points));
    if (open.empty())
      continue;
    if (&level == levels && search_distance > 0.)
      found = candidates(*information, search_distance);
    for (Along& along : found)
      along = nearest_minimum(*information, along, level.first_step);
  }
  // Only the finest images tell bone from muscle well enough to choose.
  Along best = zero;
  result.information_before = -(least = information->GetValue(zero));
  for (const Along& along : found) {
    const double value = information->GetValue(along);
    if (value < least && (search_distance == 0. || along.inf_norm() <= search_distance)) {
      least = value;
      best = along;
    }
  }
  result.information_after = -least;
  result.transform = information->transform(best);
  return result;
}

} // namespace prosup::image
