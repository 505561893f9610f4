#ifndef PROSUP_SRC_SETTLING_DECAY_FORECAST_H
#define PROSUP_SRC_SETTLING_DECAY_FORECAST_H

#include <optional>

namespace prosup::settling {

/// How long a simulation takes to settle: damped motion decays, so that the logarithm of its error
/// falls linearly from its peak to that of the tolerance.
class DecayForecast {
public:
  /// The error over its tolerance after a block of steps, at the time `now`, s.
  void add(double error, double now);
  /// After a return to an earlier state.
  void restart() { *this = {}; }

  /// s; nothing until the error has fallen far enough to tell.
  std::optional<double> seconds_left() const;

private:
  double peak_ = 0., peak_time_ = 0., error_ = 0., time_ = 0.;
  unsigned n_since_peak_ = 0;
};

} // namespace prosup::settling

#endif
