#ifndef PROSUP_SRC_PIPELINE_CHECKPOINTS_H
#define PROSUP_SRC_PIPELINE_CHECKPOINTS_H

#include <deal.II/base/parameter_handler.h>
#include <mpi.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "prosup/core/log.h"
#include "prosup/core/remarks.h"
#include "prosup/output/hdf5_file.h"
#include "prosup/pipeline/checkpoint_parameters.h"
#include "run_identity.h"

namespace prosup::pipeline {

/// The two files in which a run is kept, one after the other, so that one is whole whenever the run
/// ends. Collective on `world`.
class Checkpoints {
public:
  /// The log of a run that was ended and can go on, beside the checkpoints.
  static constexpr const char* log_of_failure = "log_of_failed_run.txt";

  /// Of the command and its run into `output` with these parameters. The contents of the files that
  /// the section Case names belong to it. Keeps references to parameters, log and
  /// remarks.
  Checkpoints(const std::string& command, const CheckpointParameters& parameters,
              const dealii::ParameterHandler& all, const std::filesystem::path& output,
              MPI_Comm world, const Log& log, Remarks& remarks);

  /// The newest whole checkpoint if the run is to go on from there; says which, or that it begins.
  /// To be asked for before the first write().
  /// @throws Error if there is one of other parameters or inputs, or only damaged ones, or the run
  /// has ended well.
  std::unique_ptr<output::Hdf5Reader> restart();

  /// Writes one if it is time: `contents` adds what the command needs. A failure is a remark and
  /// does not end the run.
  void keep(const std::function<void(output::Hdf5Writer&)>& contents);
  /// Removes them: the run has ended well.
  void remove();

private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path file(unsigned slot) const;
  bool is_time() const;
  void write(const std::function<void(output::Hdf5Writer&)>& contents);
  void compare(const output::Hdf5Reader& checkpoint) const;

  const std::string kind_;
  const CheckpointParameters& parameters_;
  const dealii::ParameterHandler& all_;
  const std::filesystem::path output_, folder_;
  MPI_Comm world_;
  const Log& log_;
  Remarks& remarks_;
  RunIdentity identity_;
  Clock::time_point last_ = Clock::now();
  unsigned sequence_ = 0; // of the last one
  unsigned slot_ = 0;     // of the next one
  unsigned n_kept_ = 0;
  double seconds_ = 0.; // that they took
};

} // namespace prosup::pipeline

#endif
