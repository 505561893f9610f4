#include "prosup/pipeline/landmark_evaluation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "prosup/evaluation/landmarks_csv.h"
#include "prosup/evaluation/point_mapper.h"

namespace prosup::pipeline {

using dealii::Point;
using evaluation::ErrorStatistics;

namespace {

constexpr double far_outside = 5.; // mm: more than masks and observers disagree about the skin
constexpr std::size_t n_named = 3;
constexpr double too_close = 2.; // mm: no three landmarks that are worth a registration

/// Whether the centre of a voxel that is not 0 lies within `distance` mm of `x`.
bool is_near(const image::LabelImage& mask, const Point<3>& x, double distance) {
  const image::VoxelGrid& grid = mask.grid;
  const Point<3> index = grid.continuous_index(x);
  std::array<std::ptrdiff_t, 3> first, last;
  for (unsigned d = 0; d < 3; ++d) {
    const double reach = distance / grid.spacing[d], end = double(grid.size[d]) - 1.;
    first[d] = std::ptrdiff_t(std::ceil(std::clamp(index[d] - reach, 0., end + 1.)));
    last[d] = std::ptrdiff_t(std::floor(std::clamp(index[d] + reach, -1., end)));
  }
  for (auto k = first[2]; k <= last[2]; ++k)
    for (auto j = first[1]; j <= last[1]; ++j)
      for (auto i = first[0]; i <= last[0]; ++i)
        if (mask(std::size_t(i), std::size_t(j), std::size_t(k)) != 0 &&
            x.distance(grid.physical(double(i), double(j), double(k))) <= distance)
          return true;
  return false;
}

/// Says so if all landmarks lie in one place, as positions in metres that are read as mm do.
void warn_of_one_place(const std::vector<Point<3>>& positions, Position position,
                       Remarks& remarks) {
  double extent = 0.;
  for (const Point<3>& x : positions)
    extent = std::max(extent, x.distance(positions.front()));
  if (positions.size() > 2 && extent < too_close)
    remarks.add(format("All %zu landmarks of the %s image lie within %.2g mm of each other; check "
                       "that they are positions in mm.",
                       positions.size(), name_of(position), extent));
}

} // namespace

void LandmarkEvaluation::read(const CaseParameters& parameters, Remarks& remarks) {
  if (parameters.landmarks().empty())
    return;
  landmarks_ = evaluation::read_landmarks(parameters.landmarks(), remarks);
  supine_offset_ = parameters.files().supine_offset;
  for (evaluation::Landmark& landmark : landmarks_)
    landmark.supine += supine_offset_;
}

void LandmarkEvaluation::check_places(Position position, const image::LabelImage& breast,
                                      Remarks& remarks) const {
  std::vector<Point<3>> positions;
  for (const evaluation::Landmark& landmark : landmarks_)
    positions.push_back(position == Position::prone ? landmark.prone : landmark.supine);
  warn_of_one_place(positions, position, remarks);
  const auto is_inside = [](std::uint8_t value) { return value != 0; };
  if (!has_landmarks() || std::all_of(breast.values.begin(), breast.values.end(), is_inside) ||
      std::none_of(breast.values.begin(), breast.values.end(), is_inside))
    return;
  std::vector<std::string> outside;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!is_near(breast, positions[i], far_outside))
      outside.push_back("'" + shown(landmarks_[i].id) + "'");
  if (outside.empty())
    return;
  const std::size_t n_outside = outside.size();
  outside.resize(std::min(n_outside, n_named));
  remarks.add(format(
      "%zu of %zu landmarks lie more than %g mm outside of the %s breast, such as %s; "
      "check that they are LPS positions in mm, of this image, and that prone and "
      "supine are not exchanged.",
      n_outside, landmarks_.size(), far_outside, name_of(position), joined(outside).c_str()));
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

void LandmarkEvaluation::add_error_bars(const PerPosition<mesh::UnloadedMesh>& meshes,
                                        const evaluation::Uncertainty::Covariances& covariances) {
  const evaluation::PointMapper prone(meshes.prone), supine(meshes.supine);
  const evaluation::Uncertainty uncertainty(prone, supine, covariances);
  for (evaluation::MappedLandmark& landmark : mapped_)
    landmark.error_bar = evaluation::error_bar(uncertainty.unloaded(landmark.from_prone.position));
}

void LandmarkEvaluation::write(const std::filesystem::path& file) const {
  if (has_landmarks())
    evaluation::write_landmarks(mapped_, file);
}

} // namespace prosup::pipeline
