#ifndef PROSUP_REGISTRATION_SIMULATED_PAIR_H
#define PROSUP_REGISTRATION_SIMULATED_PAIR_H

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "prosup/mechanics/laws/tissue_material.h"
#include "prosup/similarity/image_force.h"
#include "prosup/unloading/unloading.h"

namespace prosup::registration {

/// What the mechanics of a breast are not known well enough for, and may be found
/// from its images.
struct MechanicalProperties {
  mechanics::TissueStiffness tissue;
  /// Of the springs between the base and the chest wall, Pa/mm; 0 if there are none.
  double chest_stiffness = 0.;
};

/// What two unloaded breasts are compared by.
enum class Compared { images, tissues };

/// Prone and supine as a simulation holds them, whatever its numerical method: what the
/// material update and the accumulation of image forces work on. All functions are
/// collective on the ranks of both states.
class SimulatedPair {
public:
  virtual ~SimulatedPair() = default;

  virtual bool has_gland() const = 0;
  virtual const MechanicalProperties& properties() const = 0;
  /// Gives both states the same tissue and the same bed.
  virtual void set_properties(const MechanicalProperties& properties) = 0;

  /// Runs both unloadings until settled, or at most `max_steps` steps if not 0.
  virtual std::array<settling::SettlingResult, 2> unload(unsigned max_steps = 0) = 0;
  /// Simulates both for `duration` times their damping time, the inverse of r/rho.
  virtual std::array<settling::SettlingResult, 2> advance(double duration) = 0;

  /// Keeps the present state in place of that kept before.
  virtual void save() = 0;
  virtual void restore() = 0;

  /// Says on which voxels (edges in mm) and by what the pair is compared from now on.
  virtual void compare_on(double level, Compared compared) = 0;
  /// The name of the measure.
  virtual std::string metric() const = 0;
  virtual double value() const = 0;
  /// Their squares add up to twice the value of the SSD, and their derivatives to those
  /// of any metric; on every rank.
  virtual std::vector<float> residuals() const = 0;

  /// Finds the image forces of the present state, and returns the value.
  virtual double find_forces(similarity::Variable variable) = 0;
  /// Adds `weight` (Pa) times the forces found and `momentum` times what was added last;
  /// they rise from 0 over `ramp` damping times.
  virtual void add_forces(double weight, double momentum, double ramp) = 0;
  /// Forgets what was added last.
  virtual void forget_momentum() = 0;
};

/// The number of steps in which an unloading simulates `duration` damping times.
template <typename Unloading>
unsigned steps_within(double duration, const Unloading& unloading) {
  const double n_steps = duration / (unloading.damping_rate() * unloading.time_step());
  return static_cast<unsigned>(std::clamp(std::ceil(n_steps), 1., 1e6));
}

} // namespace prosup::registration

#endif
