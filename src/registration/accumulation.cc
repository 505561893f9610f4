#include <algorithm>

#include "prosup/core/error.h"
#include "prosup/registration/image_force_registration.h"

namespace prosup::registration {

namespace {

constexpr double weight_growth = 1.2;
constexpr unsigned max_rejections = 5; // in a row, before a level is given up
constexpr unsigned patience = 3;       // updates in a row with hardly any gain

} // namespace

/// The updates on one image level.
class ImageForceRegistration::Accumulation {
public:
  Accumulation(const ImageForceRegistration& parameters, BreastPair& pair,
               const ComparedImages& images, double level, const Log& log, const Observer& observer)
      : parameters_(parameters), pair_(pair), comparison_(pair, images, Compared::images, level),
        variable_(parameters.accumulated_.force_gradient == "transformed"
                      ? similarity::Variable::transformed_displacement
                      : similarity::Variable::displacement),
        log_(log), observer_(observer) {
    forget_momentum();
  }

  /// Updates until nothing more is gained; returns the weight at the end.
  double run(double weight, ImageForceResult& result) {
    double current = comparison_.set_image_forces(variable_);
    record(0, 0., current);
    unsigned n_rejected = 0, n_idle = 0;
    const unsigned n_before = result.n_updates;
    for (unsigned i = 1; i <= parameters_.updates_per_level_;) {
      pair_.save();
      double next = 0.;
      if (!push(weight, result) || !((next = comparison_.set_image_forces(variable_)) < current)) {
        pair_.restore();
        forget_momentum();
        weight *= 0.5;
        if (++n_rejected > max_rejections)
          break;
        // The state may have been on its way past where its forces hold it.
        count(pair_.advance(parameters_.accumulated_.time_per_update), result);
        current = comparison_.set_image_forces(variable_);
        continue;
      }
      n_rejected = 0;
      record(i++, weight, next);
      ++result.n_updates;
      n_idle = current - next < parameters_.accumulated_.least_gain * current ? n_idle + 1 : 0;
      current = next;
      if (n_idle >= patience)
        break;
      weight *= weight_growth;
    }
    log_.line(format("  level %g mm: %s %.4g after %u updates", comparison_.level(),
                     comparison_.name().c_str(), current, result.n_updates - n_before));
    return weight;
  }

private:
  /// Adds the weighted forces and simulates; false if an element came near
  /// inversion.
  bool push(double weight, ImageForceResult& result) {
    try {
      const double ramp =
          parameters_.accumulated_.ramp_fraction * parameters_.accumulated_.time_per_update;
      pair_.for_each([&](Position, Breast& breast) {
        breast.add_image_forces(weight, parameters_.accumulated_.momentum, ramp);
      });
      const auto unloaded = pair_.advance(parameters_.accumulated_.time_per_update);
      count(unloaded, result);
      return std::min(unloaded.prone.min_jacobian, unloaded.supine.min_jacobian) >
                 parameters_.smallest_jacobian_ &&
             unloaded.prone.n_retries + unloaded.supine.n_retries == 0;
    } catch (const Error&) {
      return false;
    }
  }

  void forget_momentum() {
    pair_.for_each([](Position, Breast& breast) { breast.forget_momentum(); });
  }

  static void count(const PerPosition<settling::SettlingResult>& unloaded,
                    ImageForceResult& result) {
    result.n_steps += unloaded.prone.n_steps + unloaded.supine.n_steps;
  }

  void record(unsigned iteration, double weight, double value) const {
    log_.progress(format("  image forces: level %g mm, update %u, weight %.1f Pa, %s %.4g",
                         comparison_.level(), iteration, weight, comparison_.name().c_str(),
                         value));
    if (observer_)
      observer_({"image_forces", comparison_.level(), iteration, weight, value});
  }

  const ImageForceRegistration& parameters_;
  BreastPair& pair_;
  const Comparison comparison_;
  const similarity::Variable variable_;
  const Log& log_;
  const Observer& observer_;
};

void ImageForceRegistration::accumulate(BreastPair& pair, const ComparedImages& images,
                                        const Log& log, const Observer& observer,
                                        ImageForceProgress& progress, const Keeper& keep) const {
  if (progress.level == 0)
    progress.weight = accumulated_.first_weight * pair.properties().tissue.shear_modulus;
  while (progress.level < levels_.size()) {
    progress.weight = Accumulation(*this, pair, images, levels_[progress.level], log, observer)
                          .run(progress.weight, progress.result);
    ++progress.level;
    keep();
  }
}

} // namespace prosup::registration
