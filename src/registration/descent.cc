#include <cmath>
#include <utility>

#include "descent_scheme.h"
#include "image_energy.h"
#include "prosup/registration/element_breast.h"
#include "prosup/registration/image_force_registration.h"

namespace prosup::registration {

/// The updates from level to level.
class ImageForceRegistration::Descent {
public:
  Descent(const ImageForceRegistration& parameters, BreastPair& pair, const Log& log,
          const Observer& observer)
      : parameters_(parameters), pair_(pair), log_(log), observer_(observer),
        energy_(pair, {parameters.smallest_jacobian_, parameters.largest_jacobian_}) {}

  /// Updates on one level until nothing more is gained; the pair has the last good
  /// state.
  unsigned run(const ComparedImages& images, double level) {
    const Comparison comparison(pair_, images, Compared::images, level);
    energy_.compare_by(comparison);
    scheme_ = make_descent_scheme(parameters_.scheme_, energy_);
    length_ = 1.;
    PairVectors present;
    pair_.for_each([&](Position position, Breast& breast) {
      present[position] = breast.elements()->unloading().unloaded();
    });
    ImageEnergyPoint point = energy_.evaluate(std::move(present), scheme_->needs_stiffness());
    report(comparison, 0, 0., point);
    unsigned n_updates = 0;
    double gained = 0.;
    while (n_updates < parameters_.updates_per_level_ && point.is_allowed) {
      const double kappa = parameters_.weight_ * pair_.properties().tissue.shear_modulus /
                           point.similarity.residual_variance;
      const double before = point.value(kappa);
      if (!std::isfinite(kappa) || !improve(point, kappa))
        break;
      pair_.for_each([&](Position position, Breast& breast) {
        breast.elements()->unloading().adopt(point.unloaded[position]);
      });
      report(comparison, ++n_updates, kappa, point);
      const double gain = 1. - point.value(kappa) / before;
      gained += gain;
      if (gain < parameters_.least_gain_ * gained)
        break;
    }
    log_.line(format("  level %g mm: %s %.4g after %u updates", level, comparison.name().c_str(),
                     point.similarity.value, n_updates));
    return n_updates;
  }

private:
  /// Moves the point along the direction of the scheme, if that makes it better.
  bool improve(ImageEnergyPoint& point, double kappa) {
    const PairVectors direction = scheme_->direction(point, kappa);
    const double first = scheme_->first_length(length_);
    for (length_ = first; length_ > scheme_->shortest_part() * first; length_ *= 0.5) {
      ImageEnergyPoint next = energy_.evaluate(energy_.moved(point.unloaded, length_, direction),
                                               scheme_->needs_stiffness());
      if (next.is_allowed && next.value(kappa) < point.value(kappa)) {
        scheme_->accept(point, next);
        point = std::move(next);
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
  ImageEnergy energy_;
  std::unique_ptr<DescentScheme> scheme_;
  double length_ = 1.; // of the last step, in its direction
};

void ImageForceRegistration::descend(BreastPair& pair, const ComparedImages& images, const Log& log,
                                     const Observer& observer, ImageForceResult& result) const {
  Descent descent(*this, pair, log, observer);
  for (const double level : levels_)
    result.n_updates += descent.run(images, level);
}

} // namespace prosup::registration
