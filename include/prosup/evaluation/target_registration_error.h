#ifndef PROSUP_EVALUATION_TARGET_REGISTRATION_ERROR_H
#define PROSUP_EVALUATION_TARGET_REGISTRATION_ERROR_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "prosup/evaluation/error_bar.h"
#include "prosup/evaluation/landmarks.h"
#include "prosup/evaluation/point_mapper.h"

namespace prosup::evaluation {

/// Statistics of n distances, mm. `std` is the sample standard deviation (divisor n - 1; 0 for
/// one value). `p95` is the 95th percentile, interpolated linearly between ranks.
struct ErrorStatistics {
  double mean = 0.;
  double std = 0.;
  double max = 0.;
  double p95 = 0.;
  std::size_t n = 0;
};

/// @throws Error if `distances` is empty or holds a value that is not finite.
ErrorStatistics statistics(std::vector<double> distances);

/// Distances between the prone and the supine position of the landmarks.
ErrorStatistics initial_error(const std::vector<Landmark>& landmarks);

/// A landmark mapped to the unloaded configuration from its prone and its supine position.
struct MappedLandmark {
  Landmark landmark;
  MappedPoint from_prone, from_supine; ///< unloaded positions, LPS mm
  std::optional<ErrorBar> error_bar{}; ///< of the distance between the two

  /// Target registration error: the distance between the two unloaded positions, mm.
  double error() const { return from_prone.position.distance(from_supine.position); }
};

std::vector<MappedLandmark> map_landmarks(const std::vector<Landmark>& landmarks,
                                          const PointMapper& prone, const PointMapper& supine);

/// Target registration error in the unloaded configuration.
ErrorStatistics unloaded_error(const std::vector<Landmark>& landmarks, const PointMapper& prone,
                               const PointMapper& supine);

/// Distances between points and their images after mapping them from the loaded configuration
/// of `from` to that of `to` and back.
ErrorStatistics inverse_consistency(const std::vector<Point<3>>& points, const PointMapper& from,
                                    const PointMapper& to);

/// One row of the table of target registration errors.
struct ErrorRow {
  std::string step;      ///< of step_name
  ErrorStatistics error; ///< mm
};

/// Names of the steps of a registration, as in Table 2 of Eiben et al. (2016).
namespace step_name {
constexpr const char* initial = "No registration";
constexpr const char* unloaded = "Unloading, generic material";
constexpr const char* material = "Material updated";
constexpr const char* image_forces = "Image forces";
} // namespace step_name

/// The table as text, one line per row: step, mean, std, p95 and max, mm.
std::string error_table(const std::vector<ErrorRow>& rows);

} // namespace prosup::evaluation

#endif
