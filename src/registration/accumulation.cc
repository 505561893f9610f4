#include <algorithm>

#include "prosup/core/error.h"
#include "prosup/registration/image_force_registration.h"

namespace prosup::registration {

using similarity::prone;
using similarity::supine;

namespace {

constexpr double weight_growth = 1.2;
constexpr unsigned max_rejections = 5; // in a row, before a level is given up
constexpr unsigned patience = 3;       // updates in a row with hardly any gain

} // namespace

/// The updates on one image level.
class ImageForceRegistration::Accumulation {
public:
  Accumulation(const ImageForceRegistration& parameters, SimulatedPair& pair, double level,
               const Log& log, const Observer& observer)
      : parameters_(parameters), pair_(pair),
        variable_(parameters.force_ == "transformed"
                      ? similarity::Variable::transformed_displacement
                      : similarity::Variable::displacement),
        level_(level), log_(log), observer_(observer) {
    pair_.compare_on(level, Compared::images);
    pair_.forget_momentum();
  }

  /// Updates until nothing more is gained; returns the weight at the end.
  double run(double weight, ImageForceResult& result) {
    double current = pair_.find_forces(variable_);
    record(0, 0., current);
    unsigned n_rejected = 0, n_idle = 0;
    const unsigned n_before = result.n_updates;
    for (unsigned i = 1; i <= parameters_.updates_per_level_;) {
      pair_.save();
      double next = 0.;
      if (!push(weight, result) || !((next = pair_.find_forces(variable_)) < current)) {
        pair_.restore();
        pair_.forget_momentum();
        weight *= 0.5;
        if (++n_rejected > max_rejections)
          break;
        // The state may have been on its way past where its forces hold it.
        count(pair_.advance(parameters_.time_per_update_), result);
        current = pair_.find_forces(variable_);
        continue;
      }
      n_rejected = 0;
      record(i++, weight, next);
      ++result.n_updates;
      n_idle = current - next < parameters_.least_fall_ * current ? n_idle + 1 : 0;
      current = next;
      if (n_idle >= patience)
        break;
      weight *= weight_growth;
    }
    log_.line(format("  level %g mm: %s %.4g after %u updates", level_, pair_.metric().c_str(),
                     current, result.n_updates - n_before));
    return weight;
  }

private:
  /// Adds the weighted forces and simulates; false if an element came near
  /// inversion.
  bool push(double weight, ImageForceResult& result) {
    try {
      pair_.add_forces(weight, parameters_.momentum_,
                       parameters_.ramp_fraction_ * parameters_.time_per_update_);
      const auto unloaded = pair_.advance(parameters_.time_per_update_);
      count(unloaded, result);
      return std::min(unloaded[prone].min_jacobian, unloaded[supine].min_jacobian) >
                 parameters_.smallest_jacobian_ &&
             unloaded[prone].n_retries + unloaded[supine].n_retries == 0;
    } catch (const Error&) {
      return false;
    }
  }

  static void count(const std::array<settling::SettlingResult, 2>& unloaded,
                    ImageForceResult& result) {
    result.n_steps += unloaded[prone].n_steps + unloaded[supine].n_steps;
  }

  void record(unsigned iteration, double weight, double value) const {
    log_.progress(format("  image forces: level %g mm, update %u, weight %.1f Pa, %s %.4g", level_,
                         iteration, weight, pair_.metric().c_str(), value));
    if (observer_)
      observer_({"image_forces", level_, iteration, weight, value});
  }

  const ImageForceRegistration& parameters_;
  SimulatedPair& pair_;
  const similarity::Variable variable_;
  const double level_;
  const Log& log_;
  const Observer& observer_;
};

ImageForceResult ImageForceRegistration::accumulate(SimulatedPair& pair, const Log& log,
                                                    const Observer& observer) const {
  ImageForceResult result;
  double weight = first_weight_ * pair.properties().tissue.shear_modulus;
  for (const double level : levels_)
    weight = Accumulation(*this, pair, level, log, observer).run(weight, result);
  settle([&] { return pair.unload(); }, log, result);
  return result;
}

} // namespace prosup::registration
