#ifndef PROSUP_PIPELINE_REGISTER_PIPELINE_H
#define PROSUP_PIPELINE_REGISTER_PIPELINE_H

#include <mpi.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "prosup/output/convergence.h"
#include "prosup/pipeline/case_parameters.h"
#include "prosup/pipeline/checkpoint_parameters.h"
#include "prosup/pipeline/landmark_evaluation.h"
#include "prosup/pipeline/outcome.h"
#include "prosup/pipeline/result_parameters.h"
#include "prosup/pipeline/result_run.h"
#include "prosup/pipeline/scan_parameters.h"
#include "prosup/registration/quality.h"
#include "prosup/registration/registration.h"

namespace prosup::pipeline {

class Checkpoints;
class ScanStage;
struct ScanStageParameters;

/// `prosup register`: a Registration whose stages are timed, evaluated at landmarks and written to
/// a result folder. run() reads like the data flow. Collective on `world`.
class RegisterPipeline {
public:
  /// Keeps references to all but the target and the struct of `scans`. `all` has the values of all
  /// parameters, for used.prm.
  RegisterPipeline(const CaseParameters& case_files, const ScanStageParameters& scans,
                   const registration::RegistrationParameters& parameters,
                   const ResultParameters& results, const CheckpointParameters& checkpoint,
                   const dealii::ParameterHandler& all, const ResultTarget& output, MPI_Comm world);
  ~RegisterPipeline();

  /// @returns whether the verdict on the registration is not that it failed. The result folder is
  /// written either way, and says so. @throws Error if there is no result.
  Outcome run();

private:
  /// Runs a stage and keeps what it did, unless a checkpoint has done it.
  void stage(const char* name, registration::Stage done, std::optional<double>& seconds,
             const std::function<void()>& work);
  void restart();
  void keep();
  void prepare_scans();
  void read();
  void align();
  void check();
  void unload();
  void match_properties();
  void match_images();
  void write();

  /// Takes the present meshes, and their error on rank 0.
  void evaluate(std::optional<evaluation::ErrorStatistics>& error);
  void note(unsigned n_steps);
  void note_properties();
  void observe(const registration::SimilarityRecord& record);
  void write_on_root();
  void judge();

  const CaseParameters& case_files_;
  const ScanParameters& scans_;
  const registration::SceneCheck& checks_;
  const similarity::SimilarityParameters& similarity_;
  const ResultParameters& results_;
  const bool aligns_;
  ResultRun run_;
  registration::Registration registration_;
  std::unique_ptr<ScanStage> preparation_;
  LandmarkEvaluation landmarks_;
  registration::RegistrationResult found_;
  registration::UncertaintyParameters::Covariances covariances_; // on rank 0
  std::vector<output::ConvergenceEntry> convergence_;
  registration::Quality quality_;
  Outcome outcome_ = Outcome::success;       // on rank 0
  std::unique_ptr<Checkpoints> checkpoints_; // null if the registration cannot be kept
};

} // namespace prosup::pipeline

#endif
