#ifndef PROSUP_SETTLING_STALL_WATCH_H
#define PROSUP_SETTLING_STALL_WATCH_H

namespace prosup::settling {

/// Detects an error that no longer falls. The smallest error in a window of 10 lag
/// times, and of at least 300 steps, has to be at least a fifth below the smallest
/// error before that window.
class StallWatch {
public:
  /// Forgets all errors.
  void restart() { is_first_ = true; }

  /// Takes the error of a healthy, fully loaded state. `duration` is the time since
  /// the last call in damping times, `lag_factor` the lag in damping times, and
  /// `n_steps` counts all steps. Returns true at the end of a window without progress.
  bool has_stalled(double error, double duration, double lag_factor, unsigned n_steps);

private:
  void start_window(double error, unsigned n_steps);

  bool is_first_ = true;
  double smallest_ = 0.;        // in this window
  double smallest_before_ = 0.; // in all windows before
  double window_ = 0.;          // damping times
  unsigned first_step_ = 0;
};

} // namespace prosup::settling

#endif
