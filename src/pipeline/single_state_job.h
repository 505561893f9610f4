#ifndef PROSUP_SRC_PIPELINE_SINGLE_STATE_JOB_H
#define PROSUP_SRC_PIPELINE_SINGLE_STATE_JOB_H

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "checkpoints.h"
#include "prosup/pipeline/all_parameters.h"
#include "prosup/pipeline/landmark_evaluation.h"
#include "prosup/pipeline/result_run.h"
#include "prosup/registration/quasi_static_breast.h"

namespace prosup::pipeline {

/// A mesh that is there already, whatever the labels.
struct GivenMesh : mesh::MeshSource {
  explicit GivenMesh(mesh::TetMesh mesh = {}) : given(std::move(mesh)) {}
  mesh::TetMesh mesh(const image::LabelImage&) const override { return given; }
  mesh::TetMesh given;
};

/// What the commands load and unload share: one breast from its labels, or a mesh, to a simulation
/// and a result folder. Collective on `world`.
class SingleStateJob {
public:
  virtual ~SingleStateJob() = default;

  /// @returns whether the simulation settled.
  bool run();

protected:
  /// `command` is its name and `simulation` what its main stage is called.
  SingleStateJob(const AllParameters& parameters, const dealii::ParameterHandler& all,
                 const ResultTarget& output, MPI_Comm world, const std::string& command,
                 std::string simulation);

  /// Reads labels and image, on rank 0.
  virtual void read();
  /// Where the mesh comes from; null: from the labels.
  virtual const mesh::MeshSource* mesh_source() const { return nullptr; }
  /// The other configuration by the chosen method.
  virtual settling::SettlingResult settle(registration::Breast& breast) = 0;
  /// The same by Newton's method.
  virtual registration::QuasiStaticSolution solve(registration::ElementBreast& breast,
                                                  const registration::QuasiStaticInput& input) = 0;
  /// Fields and images of `mesh_`, on rank 0.
  virtual void write_images(const std::filesystem::path& folder) const = 0;
  /// Distances of landmarks from their true unloaded positions, where known.
  virtual std::optional<evaluation::ErrorStatistics> error() const { return {}; }

  /// Writes the field from the unloaded to the loaded configuration of a mesh.
  image::VectorImage write_field(const mesh::UnloadedMesh& mesh,
                                 const std::filesystem::path& file) const;
  /// The original image on the grid of a field, written if there is one.
  std::optional<image::ScalarImage> write_warped(const image::VectorImage& field,
                                                 const std::filesystem::path& file) const;

  /// The steps that 'Unloading/Maximum steps' leaves to a run that goes on; 0 if it begins.
  unsigned steps_left() const;

  const AllParameters& parameters_;
  const Position position_;
  const std::string name_; ///< of the position
  similarity::Scene scene_;
  std::optional<registration::OriginalImage> original_; ///< on rank 0
  LandmarkEvaluation landmarks_;
  mesh::UnloadedMesh mesh_; ///< on rank 0

private:
  void check();
  void build();
  void simulate();
  void simulate_explicitly();
  /// Takes breast and progress from the last checkpoint if it is wanted and there.
  void restart();
  void keep(bool is_done);
  void write();
  std::string report() const;

  MPI_Comm world_;
  const std::string simulation_;
  ResultRun run_;
  Checkpoints checkpoints_;
  std::unique_ptr<GivenMesh> given_mesh_; // of a checkpoint
  std::unique_ptr<registration::Breast> breast_;
  unsigned steps_before_ = 0; // of the run that the checkpoint is of
  bool is_done_ = false;      // by that run
};

} // namespace prosup::pipeline

#endif
