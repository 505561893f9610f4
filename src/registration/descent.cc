#include <cmath>
#include <utility>

#include "descent_scheme.h"
#include "image_energy.h"
#include "prosup/registration/image_force_registration.h"

namespace prosup::registration {

/// The updates from level to level.
class ImageForceRegistration::Descent {
public:
  Descent(const ImageForceRegistration& parameters, BodyPair& pair, const SimilaritySetup& setup,
          const Log& log, const Observer& observer)
      : parameters_(parameters), pair_(pair), setup_(setup), log_(log), observer_(observer),
        energy_(pair, setup, parameters.smallest_jacobian_) {}

  /// Updates on one level until nothing more is gained; the pair has the last good
  /// state.
  unsigned run(const similarity::Scene& scene, double level) {
    energy_.set_level(scene, level);
    scheme_ = make_descent_scheme(parameters_.scheme_, energy_);
    length_ = 1.;
    StateVectors present;
    pair_.for_each(
        [&](State which, BodyState& state) { present[which] = state.unloading->unloaded(); });
    ImageEnergyPoint point = energy_.evaluate(std::move(present), scheme_->needs_stiffness());
    report(level, 0, 0., point);
    unsigned n_updates = 0;
    double gained = 0.;
    while (n_updates < parameters_.updates_per_level_ && point.is_allowed) {
      const double kappa = parameters_.image_weight_ * pair_.properties().tissue.shear_modulus /
                           point.similarity.residual_variance;
      const double before = point.value(kappa);
      if (!std::isfinite(kappa) || !improve(point, kappa))
        break;
      pair_.for_each(
          [&](State which, BodyState& state) { state.unloading->adopt(point.unloaded[which]); });
      report(level, ++n_updates, kappa, point);
      const double gain = 1. - point.value(kappa) / before;
      gained += gain;
      if (gain < parameters_.least_gain_ * gained)
        break;
    }
    log_.line(format("  level %g mm: %s %.4g after %u updates", level,
                     setup_.metric().name().c_str(), point.similarity.value, n_updates));
    return n_updates;
  }

private:
  /// Moves the point along the direction of the scheme, if that makes it better.
  bool improve(ImageEnergyPoint& point, double kappa) {
    const StateVectors direction = scheme_->direction(point, kappa);
    const double first = scheme_->first_length(length_);
    for (length_ = first; length_ > scheme_->shortest_part() * first; length_ *= 0.5) {
      StateVectors trial = point.unloaded;
      add(trial, length_, direction);
      ImageEnergyPoint next = energy_.evaluate(std::move(trial), scheme_->needs_stiffness());
      if (next.is_allowed && next.value(kappa) < point.value(kappa)) {
        scheme_->accept(point, next);
        point = std::move(next);
        return true;
      }
    }
    return false;
  }

  void report(double level, unsigned update, double kappa, const ImageEnergyPoint& point) const {
    log_.progress(format("  image forces: level %g mm, update %u, weight %.0f Pa, %s %.4g", level,
                         update, kappa, setup_.metric().name().c_str(), point.similarity.value));
    if (observer_)
      observer_({"image_forces", level, update, kappa, point.similarity.value});
  }

  const ImageForceRegistration& parameters_;
  BodyPair& pair_;
  const SimilaritySetup& setup_;
  const Log& log_;
  const Observer& observer_;
  ImageEnergy energy_;
  std::unique_ptr<DescentScheme> scheme_;
  double length_ = 1.; // of the last step, in its direction
};

void ImageForceRegistration::run_descent(BodyPair& pair, const SimilaritySetup& setup,
                                         const similarity::Scene& scene, const Log& log,
                                         const Observer& observer, ImageForceResult& result) const {
  Descent descent(*this, pair, setup, log, observer);
  for (const double level : levels_)
    result.n_updates += descent.run(scene, level);
}

} // namespace prosup::registration
