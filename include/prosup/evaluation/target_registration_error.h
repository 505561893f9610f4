#ifndef PROSUP_EVALUATION_TARGET_REGISTRATION_ERROR_H
#define PROSUP_EVALUATION_TARGET_REGISTRATION_ERROR_H

#include <cstddef>
#include <string>
#include <vector>

#include "prosup/evaluation/landmarks.h"
#include "prosup/evaluation/point_mapper.h"

namespace prosup::evaluation {

/// Statistics of n distances, mm. `std` is the sample standard deviation
/// (divisor n - 1; 0 for one value), `p95` the 95th percentile, interpolated
/// linearly between ranks.
struct ErrorStatistics {
  double mean = 0.;
  double std = 0.;
  double max = 0.;
  double p95 = 0.;
  std::size_t n = 0;
};

/// @throws Error if `distances` is empty or holds a value that is not finite.
ErrorStatistics statistics(std::vector<double> distances);

/// Distance between the prone and the supine position, before any registration.
ErrorStatistics initial_error(const std::vector<Landmark>& landmarks);

/// A landmark mapped to the unloaded configuration from both sides.
struct MappedLandmark {
  Landmark landmark;
  MappedPoint from_prone, from_supine; ///< unloaded positions, LPS mm

  /// Target registration error: the distance of the two, mm.
  double error() const { return from_prone.position.distance(from_supine.position); }
};

std::vector<MappedLandmark> map_landmarks(const std::vector<Landmark>& landmarks,
                                          const PointMapper& prone, const PointMapper& supine);

/// Target registration error in the unloaded configuration.
ErrorStatistics unloaded_error(const std::vector<Landmark>& landmarks, const PointMapper& prone,
                               const PointMapper& supine);

/// Distance of points of the loaded state `from` from where they are after the way to
/// the other loaded state and back.
ErrorStatistics inverse_consistency(const std::vector<Point<3>>& points, const PointMapper& from,
                                    const PointMapper& to);

/// One row of the table of target registration errors.
struct ErrorRow {
  std::string step;
  ErrorStatistics error;
};

/// Names of the steps of a registration, as in Table 2 of Eiben et al. (2016).
namespace step_name {
constexpr const char* initial = "No registration";
constexpr const char* unloaded = "Unloading, generic material";
constexpr const char* material = "Material updated";
constexpr const char* image_forces = "Image forces";
} // namespace step_name

/// The table as text: step, mean, std, p95, max (mm), one line per row.
std::string error_table(const std::vector<ErrorRow>& rows);

} // namespace prosup::evaluation

#endif
