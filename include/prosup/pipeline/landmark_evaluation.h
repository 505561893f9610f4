#ifndef PROSUP_PIPELINE_LANDMARK_EVALUATION_H
#define PROSUP_PIPELINE_LANDMARK_EVALUATION_H

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/evaluation/landmarks.h"
#include "prosup/evaluation/target_registration_error.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"
#include "prosup/pipeline/case_parameters.h"

namespace prosup::pipeline {

/// Target registration errors of the stages of a registration, at landmarks that the registration
/// does not know. For one rank.
class LandmarkEvaluation {
public:
  /// Reads the landmarks of a case; without a file there is nothing to evaluate. What is doubtful
  /// goes to `remarks`.
  void read(const CaseParameters& parameters, Remarks& remarks);

  /// Says which landmarks lie outside of the breast, whose mask in one position is `breast`: they
  /// may be in another coordinate system, in another unit or of another position.
  void check_places(Position position, const image::LabelImage& breast, Remarks& remarks) const;

  bool has_landmarks() const { return !landmarks_.empty(); }

  std::optional<evaluation::ErrorStatistics> initial() const;

  /// Errors in the unloaded configuration, and the mapped landmarks.
  std::optional<evaluation::ErrorStatistics>
  evaluate(const PerPosition<mesh::UnloadedMesh>& meshes);

  /// Gives the landmarks of the last evaluation their error bars.
  void add_error_bars(const PerPosition<mesh::UnloadedMesh>& meshes,
                      const evaluation::Uncertainty::Covariances& covariances);

  /// Distances of the unloaded positions found for one breast from the true ones, where these are
  /// known.
  std::optional<evaluation::ErrorStatistics> evaluate(Position position,
                                                      const mesh::UnloadedMesh& mesh) const;

  /// The landmarks of the last evaluation, as CSV.
  void write(const std::filesystem::path& file) const;

private:
  std::vector<evaluation::Landmark> landmarks_;
  std::vector<evaluation::MappedLandmark> mapped_;
  dealii::Tensor<1, 3> supine_offset_;
};

} // namespace prosup::pipeline

#endif
