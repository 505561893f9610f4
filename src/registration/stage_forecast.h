#ifndef PROSUP_SRC_REGISTRATION_STAGE_FORECAST_H
#define PROSUP_SRC_REGISTRATION_STAGE_FORECAST_H

#include <optional>
#include <utility>
#include <vector>

#include "prosup/core/remaining_time.h"
#include "prosup/registration/comparison.h"

namespace prosup::registration {

/// How long a stage takes that goes from level to level in steps, and leaves a level when a step
/// gains less than `least_gain` of all that was gained there. The gains of a level fall about
/// geometrically, which tells how many steps are left on it; a level that has not begun is expected
/// to take as many as usual. The time of a step is that of the last level with steps, in proportion
/// to the cost of both levels.
class StepForecast {
public:
  /// `costs` are those of a step on each level, in any unit.
  StepForecast(std::vector<double> costs, double least_gain)
      : costs_(std::move(costs)), least_gain_(least_gain) {}

  /// `level`, counted from 0, begins with this dissimilarity.
  void begin(std::size_t level, double value, double now);
  /// A step on it was accepted. Times are in s.
  void step(double value, double now);

  /// s from the last call on; nothing until two steps were made.
  std::optional<double> seconds_left() const;

private:
  double steps_left() const;

  const std::vector<double> costs_;
  const double least_gain_;
  std::size_t level_ = 0, measured_level_ = 0;
  unsigned n_steps_ = 0, n_all_ = 0;               // on the level; on all
  double first_ = 0., last_ = 0., last_gain_ = 0.; // dissimilarity
  double now_ = 0., step_time_ = 0.;               // mean on the measured level
};

/// `observer` with the time that remains in the live line. It is to be handed to a stage in its
/// place, and to live as long as the stage runs.
class StageForecast {
public:
  /// `levels` are mm. Keeps a reference to `observer`.
  StageForecast(std::vector<double> levels, StepForecast forecast, const Observer& observer)
      : levels_(std::move(levels)), observer_(observer), forecast_(std::move(forecast)) {}

  /// Refers to this.
  Observer observer();

private:
  void see(const SimilarityRecord& record);

  const std::vector<double> levels_;
  const Observer& observer_;
  RemainingTime remaining_;
  StepForecast forecast_;
  double level_ = 0.; // mm, of the last record
};

} // namespace prosup::registration

#endif
