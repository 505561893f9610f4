#include <algorithm>
#include <cmath>
#include <utility>

#include "descent_scheme.h"
#include "image_energy.h"
#include "prosup/registration/element_breast.h"
#include "prosup/registration/image_force_registration.h"
#include "stage_forecast.h"

namespace prosup::registration {

namespace {

constexpr double largest_weight_factor = 10.; // beyond it single cells follow the noise

} // namespace

/// The updates from level to level.
class ImageForceRegistration::Descent {
public:
  Descent(const ImageForceRegistration& parameters, BreastPair& pair, const Log& log,
          const Observer& observer, ImageForceProgress& progress, const Keeper& keep)
      : parameters_(parameters), pair_(pair), log_(log), observer_(observer), progress_(progress),
        keep_(keep), energy_(pair, {parameters.smallest_jacobian_, parameters.largest_jacobian_},
                             progress.start) {
    progress_.start = energy_.start();
  }

  /// Updates on the present level until nothing more is gained; the pair has the last good
  /// state.
  void run(const ComparedImages& images) {
    const double level = parameters_.levels_[progress_.level];
    const Comparison comparison(pair_, images, Compared::images, level, progress_.grid);
    energy_.compare_by(comparison);
    scheme_ = make_descent_scheme(parameters_.scheme_, energy_);
    ImageEnergyPoint point = begin(comparison);
    unsigned& n_updates = progress_.n_updates;
    while (n_updates < parameters_.updates_per_level_ && point.is_allowed) {
      if (n_updates == 0 || !scheme_->remembers_steps())
        keep_();
      const double kappa = weight(point) * pair_.properties().tissue.shear_modulus /
                           point.similarity.residual_variance;
      const double before = point.value(kappa);
      if (!std::isfinite(kappa) || !improve(point, kappa))
        break;
      adopt(point);
      report(comparison, ++n_updates, kappa, point);
      const double gain = 1. - point.value(kappa) / before;
      progress_.gained += gain;
      if (gain < parameters_.least_gain_ * progress_.gained)
        break;
    }
    log_.line(format("  level %g mm: %s %.4g after %u updates; moved by %.2f mm", level,
                     comparison.name().c_str(), point.similarity.value, n_updates,
                     energy_.distance(point)));
    progress_.result.n_updates += n_updates;
  }

private:
  /// The present point: that at which the level begins, or to which it had come before.
  ImageEnergyPoint begin(const Comparison& comparison) {
    PairVectors present;
    if (progress_.n_updates > 0)
      present = progress_.present;
    else
      pair_.for_each([&](Position position, Breast& breast) {
        present[position] = breast.elements()->unloading().unloaded();
      });
    ImageEnergyPoint point = energy_.evaluate(std::move(present), scheme_->needs_stiffness());
    if (progress_.grid.n_voxels() > 0) { // it goes on
      if (progress_.n_updates > 0)
        adopt(point); // sets the planes of sliding nodes, too
      return point;
    }
    progress_.grid = comparison.domain().grid;
    progress_.gained = 0.;
    progress_.length = 1.;
    report(comparison, 0, 0., point);
    return point;
  }

  /// w: a model that the images contradict counts less.
  double weight(const ImageEnergyPoint& point) const {
    const double expected = parameters_.model_error_;
    return parameters_.weight_ * (expected > 0. ? std::clamp(energy_.distance(point) / expected, 1.,
                                                             largest_weight_factor)
                                                : 1.);
  }

  void adopt(const ImageEnergyPoint& point) {
    pair_.for_each([&](Position position, Breast& breast) {
      breast.elements()->unloading().adopt(point.unloaded[position]);
    });
  }

  /// Moves the point along the direction of the scheme, if that makes it better.
  bool improve(ImageEnergyPoint& point, double kappa) {
    const PairVectors direction = scheme_->direction(point, kappa);
    const double first = scheme_->first_length(progress_.length);
    double& length = progress_.length;
    for (length = first; length > scheme_->shortest_part() * first; length *= 0.5) {
      PairVectors trial = energy_.moved(point.unloaded, length, direction);
      ImageEnergyPoint next = energy_.evaluate(trial, scheme_->needs_stiffness());
      if (next.is_allowed && next.value(kappa) < point.value(kappa)) {
        scheme_->accept(point, next);
        point = std::move(next);
        progress_.present = std::move(trial);
        return true;
      }
    }
    return false;
  }

  void report(const Comparison& comparison, unsigned update, double kappa,
              const ImageEnergyPoint& point) const {
    log_.progress(format("  image forces: level %g mm, update %u, weight %.0f Pa, %s %.4g",
                         comparison.level(), update, kappa, comparison.name().c_str(),
                         point.similarity.value));
    if (observer_)
      observer_({"image_forces", comparison.level(), update, kappa, point.similarity.value});
  }

  const ImageForceRegistration& parameters_;
  BreastPair& pair_;
  const Log& log_;
  const Observer& observer_;
  ImageForceProgress& progress_;
  const Keeper& keep_;
  ImageEnergy energy_;
  std::unique_ptr<DescentScheme> scheme_;
};

void ImageForceRegistration::descend(BreastPair& pair, const ComparedImages& images, const Log& log,
                                     const Observer& observer, ImageForceProgress& progress,
                                     const Keeper& keep) const {
  std::vector<double> costs;
  for (const double level : levels_)
    costs.push_back(1. / (level * level)); // between that of the nodes and that of the voxels
  StageForecast forecast(levels_, {costs, least_gain_}, observer);
  const Observer told = forecast.observer();
  Descent descent(*this, pair, log, told, progress, keep);
  while (progress.level < levels_.size()) {
    descent.run(images);
    ++progress.level;
    progress.n_updates = 0;
    progress.grid = {};
    keep();
  }
}

} // namespace prosup::registration
