#ifndef PROSUP_PIPELINE_STAGE_TIMER_H
#define PROSUP_PIPELINE_STAGE_TIMER_H

#include <mpi.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "prosup/core/log.h"

namespace prosup::pipeline {

/// Wall times of the stages of a run. A stage ends when its slowest rank is done.
class StageTimer {
public:
  /// Starts the time. Keeps a reference to the log.
  StageTimer(MPI_Comm communicator, const Log& log);

  /// Prints the name of a stage and runs it. Collective.
  void run(const std::string& name, const std::function<void()>& stage);

  /// Runs work whose time does not count, such as the evaluation at landmarks.
  void set_aside(const std::function<void()>& work);

  double seconds(const std::string& name) const; ///< 0 for a stage that did not run
  double total() const;                          ///< since the start but for what was set aside, s

  /// The table of all stages.
  std::string table() const;

private:
  struct Stage {
    std::string name;
    double seconds;
  };

  MPI_Comm communicator_;
  const Log& log_;
  std::chrono::steady_clock::time_point start_;
  double set_aside_ = 0.; // s
  std::vector<Stage> stages_;
};

/// Sum of the peak memory of all processes of the communicator, MiB. Collective.
double peak_memory(MPI_Comm communicator);

} // namespace prosup::pipeline

#endif
