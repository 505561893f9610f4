#ifndef PROSUP_PIPELINE_SINGLE_STATE_JOB_H
#define PROSUP_PIPELINE_SINGLE_STATE_JOB_H

#include <memory>
#include <optional>
#include <string>

#include "prosup/output/summary.h"
#include "prosup/pipeline/body_building.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/landmark_evaluation.h"
#include "prosup/pipeline/stage_timer.h"

namespace prosup::pipeline {

/// What unload and load share: one state from its labels to a mesh, a
/// simulation, and a result folder; on all ranks of a communicator.
class SingleStateJob {
public:
  virtual ~SingleStateJob() = default;

  /// @returns whether the simulation settled.
  bool run(const dealii::ParameterHandler& parameters, const std::filesystem::path& output);

protected:
  /// `command` is its name and `simulation` what its main stage is called.
  SingleStateJob(const Stages& stages, MPI_Comm world, std::string command, std::string simulation);

  /// Reads labels and image, on rank 0.
  virtual void read();
  /// The mesh to start with, on rank 0.
  virtual mesh::TetMesh make_mesh() { return stages_.mesher.mesh(labels_); }
  /// Both configurations of the body (on rank 0) from the mesh.
  virtual mesh::UnloadedMesh simulate(mesh::TetMesh mesh) = 0;
  /// Fields and images of `mesh_`, on rank 0.
  virtual void write_images(const std::filesystem::path& folder) const = 0;

  /// Distances of landmarks from their true unloaded positions, where known.
  virtual std::optional<evaluation::ErrorStatistics> error() const { return {}; }

  enum class Direction { load, unload };
  /// The other configuration of a body whose nodes stand where they do in the
  /// mesh, by the chosen solver: loaded or unloaded positions, mm. Collective.
  mechanics::NodeVector equilibrium(const mechanics::Body& body, Direction direction);

  /// Writes the field from the unloaded to the loaded configuration of a mesh.
  image::VectorImage write_field(const mesh::UnloadedMesh& mesh,
                                 const std::filesystem::path& file) const;
  /// The original image on the grid of a field, written if there is one.
  std::optional<image::ScalarImage> write_warped(const image::VectorImage& field,
                                                 const std::filesystem::path& file) const;

  const Stages& stages_;
  const unsigned state_;
  const std::string name_; ///< of the state
  MPI_Comm world_;
  const Log log_;
  image::LabelImage labels_; ///< on rank 0
  std::optional<OriginalImage> original_;
  LandmarkEvaluation landmarks_;
  mesh::UnloadedMesh mesh_;
  unsigned n_steps_ = 0;
  bool converged_ = false;

private:
  std::unique_ptr<mechanics::Supports> make_supports(const mechanics::Body& body);
  mechanics::NodeVector settle(mechanics::Supports& supports, Direction direction);
  mechanics::NodeVector solve(mechanics::Supports& supports, Direction direction);
  mechanics::Material material(const mechanics::Body& body) const;
  void write(const dealii::ParameterHandler& parameters, const std::filesystem::path& folder) const;
  output::Summary summary(double memory) const;

  const std::string command_, simulation_;
  StageTimer timer_;
  image::LabelImage other_labels_;
};

} // namespace prosup::pipeline

#endif
