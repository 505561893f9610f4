#ifndef PROSUP_PIPELINE_RESULT_RUN_H
#define PROSUP_PIPELINE_RESULT_RUN_H

#include <deal.II/base/parameter_handler.h>
#include <mpi.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "prosup/core/log.h"
#include "prosup/core/log_file.h"
#include "prosup/core/remarks.h"
#include "prosup/core/result_folder.h"
#include "prosup/output/summary.h"
#include "prosup/pipeline/stage_timer.h"

namespace prosup::pipeline {

/// One run of a command that writes a result folder: the folder, the timed stages and the summary.
/// The results are in place after finish(), and not before. Collective on `world`.
class ResultRun {
public:
  /// Says what runs, and makes the temporary folder. `parameters` go to used.prm; keeps a
  /// reference to them. @throws Error as ResultFolder does.
  ResultRun(const std::string& command, const dealii::ParameterHandler& parameters,
            const ResultTarget& output, MPI_Comm world);
  ~ResultRun();
  ResultRun(const ResultRun&) = delete;
  ResultRun& operator=(const ResultRun&) = delete;

  /// If the run does not come to its end, its log becomes `file`, provided that the folder of the
  /// file is there by then: where something of such a run is kept.
  void keep_log_of_failure(const std::filesystem::path& file);

  const Log& log() const { return log_; }
  /// Where the files go until finish(); the same on all ranks.
  const std::filesystem::path& folder() const { return folder_; }
  /// What finish() writes to summary.json; only that of rank 0 counts.
  output::Summary& summary() { return summary_; }

  /// Says what is doubtful, and keeps it as a warning of the summary; on rank 0.
  Remarks& remarks() { return remarks_; }

  /// Announces, runs and times a stage. What it throws is told to the log file.
  void stage(const std::string& name, const std::function<void()>& work);
  /// Runs what does not count as time of the run: its evaluation.
  void set_aside(const std::function<void()>& work) { timer_.set_aside(work); }
  /// Of the stages of that name, and of all, s.
  double seconds(const std::string& name) const { return timer_.seconds(name); }
  double seconds() const { return timer_.total(); }

  /// Writes used.prm and summary.json, then on rank 0 what `write_last` makes of all files, prints
  /// the times and the `report`, which end the log file, and moves the results into place.
  /// @returns Summary::converged.
  bool finish(
      const std::string& report = "", const std::function<void()>& write_last = [] {});

private:
  void save_log() const;

  MPI_Comm world_;
  const dealii::ParameterHandler& parameters_;
  const std::filesystem::path output_;
  const Log log_;
  Remarks remarks_;
  StageTimer timer_;
  std::unique_ptr<ResultFolder> result_;   // on rank 0
  std::unique_ptr<Unfinished> unfinished_; // on the others
  std::filesystem::path folder_;
  std::unique_ptr<LogFile> log_file_;
  std::filesystem::path log_of_failure_;    // empty: it is not kept
  std::unique_ptr<Unfinished> unsaved_log_; // on rank 0; is saved before the folder is cleared away
  output::Summary summary_;
};

} // namespace prosup::pipeline

#endif
