#ifndef PROSUP_PIPELINE_REGISTER_PIPELINE_H
#define PROSUP_PIPELINE_REGISTER_PIPELINE_H

#include <deal.II/base/parameter_handler.h>
#include <mpi.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "prosup/core/log.h"
#include "prosup/output/convergence.h"
#include "prosup/output/summary.h"
#include "prosup/pipeline/landmark_evaluation.h"
#include "prosup/pipeline/registration_method.h"
#include "prosup/pipeline/stage_timer.h"
#include "prosup/pipeline/stages.h"

namespace prosup::pipeline {

/// The main job: both images and masks to the registered unloaded pair. run()
/// reads like the data flow; collective on `world`.
class RegisterPipeline {
public:
  /// `stages` have their values from `parameters`, which go to used.prm.
  RegisterPipeline(const Stages& stages, const dealii::ParameterHandler& parameters,
                   MPI_Comm world);

  /// @returns whether all simulations settled. The result folder is written
  /// either way, and says so.
  /// @throws Error if there is no result.
  bool run(const std::filesystem::path& output);

private:
  void read();
  void align();
  void build();
  void unload();
  void update_material();
  void push_with_image_forces();
  void write(const std::filesystem::path& folder);

  /// Gathers the unloaded meshes and takes their error.
  void evaluate(std::optional<evaluation::ErrorStatistics>& error);
  void record(const std::array<settling::SettlingResult, 2>& results);
  registration::Observer observer();
  void add_mesh_summaries();

  const Stages& stages_;
  const dealii::ParameterHandler& parameters_;
  const Log log_;
  const registration::RankSplit ranks_;
  StageTimer timer_;
  const std::unique_ptr<RegistrationMethod> method_;
  LandmarkEvaluation landmarks_;
  Inputs inputs_;
  std::array<mesh::UnloadedMesh, 2> unloaded_;
  std::vector<output::ConvergenceEntry> convergence_;
  output::Summary summary_;
};

} // namespace prosup::pipeline

#endif
