#ifndef PROSUP_SRC_REGISTRATION_STEPS_WITHIN_H
#define PROSUP_SRC_REGISTRATION_STEPS_WITHIN_H

#include <algorithm>
#include <cmath>

namespace prosup::registration {

/// The number of steps in which an unloading simulates `duration` damping times.
template <typename Unloading>
unsigned steps_within(double duration, const Unloading& unloading) {
  const double n_steps = duration / (unloading.damping_rate() * unloading.time_step());
  return static_cast<unsigned>(std::clamp(std::ceil(n_steps), 1., 1e6));
}

} // namespace prosup::registration

#endif
