#include "prosup/pipeline/landmark_evaluation.h"

#include "prosup/evaluation/landmarks_csv.h"
#include "prosup/evaluation/point_mapper.h"

namespace prosup::pipeline {

using evaluation::ErrorStatistics;

void LandmarkEvaluation::read(const CaseParameters& parameters) {
  if (parameters.landmarks().empty())
    return;
  landmarks_ = evaluation::read_landmarks(parameters.landmarks());
  supine_offset_ = parameters.files().supine_offset;
  for (evaluation::Landmark& landmark : landmarks_)
    landmark.supine += supine_offset_;
}

std::optional<ErrorStatistics> LandmarkEvaluation::initial() const {
  if (!has_landmarks())
    return {};
  return evaluation::initial_error(landmarks_);
}

std::optional<ErrorStatistics>
LandmarkEvaluation::evaluate(const PerPosition<mesh::UnloadedMesh>& meshes) {
  if (!has_landmarks())
    return {};
  mapped_ = evaluation::map_landmarks(landmarks_, evaluation::PointMapper(meshes.prone),
                                      evaluation::PointMapper(meshes.supine));
  std::vector<double> errors;
  for (const evaluation::MappedLandmark& landmark : mapped_)
    errors.push_back(landmark.error());
  return evaluation::statistics(std::move(errors));
}

std::optional<ErrorStatistics> LandmarkEvaluation::evaluate(Position position,
                                                            const mesh::UnloadedMesh& mesh) const {
  const evaluation::PointMapper mapper(mesh);
  std::vector<double> errors;
  for (const evaluation::Landmark& landmark : landmarks_)
    if (landmark.unloaded)
      // The true unloaded shape of a supine breast that lies elsewhere does so too.
      errors.push_back(
          position == Position::prone
              ? mapper.to_unloaded(landmark.prone).distance(*landmark.unloaded)
              : mapper.to_unloaded(landmark.supine).distance(*landmark.unloaded + supine_offset_));
  if (errors.empty())
    return {};
  return evaluation::statistics(std::move(errors));
}

void LandmarkEvaluation::write(const std::filesystem::path& file) const {
  if (has_landmarks())
    evaluation::write_landmarks(mapped_, file);
}

} // namespace prosup::pipeline
