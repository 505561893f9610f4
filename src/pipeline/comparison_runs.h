#ifndef PROSUP_PIPELINE_COMPARISON_RUNS_H
#define PROSUP_PIPELINE_COMPARISON_RUNS_H

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "peers.h"
#include "planned_runs.h"
#include "prosup/pipeline/case_parameters.h"
#include "prosup/pipeline/comparison_parameters.h"
#include "run_outcome.h"

namespace prosup::pipeline {

/// Makes the runs of a comparison, one after the other, each as a process of its own.
class ComparisonRuns {
public:
  /// `folder` holds used.prm, which the runs of prosup read, and gets `logs`.
  /// `tissues` are the labels of the breast. Keeps references to the parameters.
  ComparisonRuns(const ComparisonParameters& parameters, const CaseParameters& case_files,
                 const std::vector<unsigned>& tissues, const std::filesystem::path& folder);

  /// One run; a failed one is told by its row.
  output::ComparisonRow make(const PlannedRun& run, unsigned n_ranks);
  output::ComparisonRow make(const Peer& peer, const std::string& name, unsigned n_threads);

private:
  using Measure = std::function<void(output::ComparisonRow&, const std::filesystem::path& log)>;
  /// Runs a command in its repetitions, measures its result and cleans up.
  void repeat(const Command& command, unsigned threads, const Measure& measure,
              output::ComparisonRow& row);
  /// What the exit code of a run says of it. @throws Error if it failed.
  std::string status(const Command& command, const ChildResult& child,
                     const std::filesystem::path& log) const;
  ChildResult run(const Command& command, unsigned threads, const std::filesystem::path& log) const;
  Command prosup(const PlannedRun& run, unsigned n_ranks) const;
  std::filesystem::path peer_parameters(const std::string& name) const;

  const ComparisonParameters& parameters_;
  const CaseParameters& case_files_;
  const std::filesystem::path folder_, work_;
  const std::filesystem::path program_; ///< as it was found at the start
  Yardstick yardstick_;
};

} // namespace prosup::pipeline

#endif
