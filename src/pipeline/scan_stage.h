#ifndef PROSUP_SRC_PIPELINE_SCAN_STAGE_H
#define PROSUP_SRC_PIPELINE_SCAN_STAGE_H

#include <mpi.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/pipeline/result_run.h"
#include "prosup/pipeline/scan_parameters.h"
#include "prosup/prepare/preparation.h"

namespace prosup::pipeline {

/// What a scan is prepared with.
struct ScanStageParameters {
  const ScanParameters& scans;
  const prepare::Preparation& preparation;
  const Labels& labels;
  bool pictures = true;
};

/// Scans to images, labels and pictures in a folder of a run. Rank 0 works.
class ScanStage {
public:
  /// Keeps references. `folder` is relative to that of the run, or empty.
  ScanStage(const ScanStageParameters& parameters, const std::filesystem::path& folder,
            ResultRun& run, MPI_Comm world);

  /// Reads, segments and writes the scan of a position.
  void run(Position position);

  /// Where run() has written.
  std::filesystem::path image(Position position) const;
  std::filesystem::path labels(Position position) const;

  /// Whether both scans were prepared, and show different contrasts. Collective.
  bool contrasts_differ() const;

  /// All doubts, one sentence each; on rank 0.
  const std::vector<std::string>& doubts() const { return doubts_; }

private:
  image::ScalarImage read(Position position);
  prepare::UserMasks read_masks(Position position);
  void segment(Position position, image::ScalarImage scan);
  void write(Position position);

  const ScanStageParameters parameters_;
  const std::filesystem::path folder_;
  ResultRun& run_;
  MPI_Comm world_;
  prepare::PreparedScan prepared_;                          // the last one, on rank 0
  PerPosition<std::optional<prepare::Contrast>> contrasts_; // on rank 0
  std::vector<std::string> doubts_;
};

} // namespace prosup::pipeline

#endif
