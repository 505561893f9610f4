#ifndef PROSUP_PIPELINE_STAGE_TIMER_H
#define PROSUP_PIPELINE_STAGE_TIMER_H

#include <mpi.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "prosup/core/log.h"

namespace prosup::pipeline {

/// Wall times of the stages of a run; a stage lasts until its slowest rank is
/// done.
class StageTimer {
public:
  StageTimer(MPI_Comm communicator, const Log& log);

  /// Announces and runs a stage. Collective.
  void run(const std::string& name, const std::function<void()>& stage);

  /// Runs what does not count as time of the run: looking at it from outside.
  void set_aside(const std::function<void()>& work);

  double seconds(const std::string& name) const; ///< 0 for a stage that did not run
  double total() const;

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

/// Most memory that each process of the communicator has used, summed over them,
/// MiB. Collective.
double peak_memory(MPI_Comm communicator);

} // namespace prosup::pipeline

#endif
