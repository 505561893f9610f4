#include "prosup/evaluation/target_registration_error.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::evaluation {

namespace {

/// Percentile of sorted values, interpolated linearly between ranks.
double percentile(const std::vector<double>& sorted, double fraction) {
  const double rank = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

} // namespace

ErrorStatistics statistics(std::vector<double> distances) {
  if (distances.empty())
    throw Error("Statistics of registration errors need at least one landmark; none was given.");
  if (!std::all_of(distances.begin(), distances.end(), [](double d) { return std::isfinite(d); }))
    throw Error("A registration error is not a finite number; check the landmark positions and "
                "the registration.");
  std::sort(distances.begin(), distances.end());
  const auto n = static_cast<double>(distances.size());
  ErrorStatistics result;
  result.n = distances.size();
  result.mean = std::accumulate(distances.begin(), distances.end(), 0.) / n;
  double squares = 0.;
  for (const double d : distances)
    squares += (d - result.mean) * (d - result.mean);
  result.std = result.n > 1 ? std::sqrt(squares / (n - 1.)) : 0.;
  result.max = distances.back();
  result.p95 = percentile(distances, 0.95);
  return result;
}

ErrorStatistics initial_error(const std::vector<Landmark>& landmarks) {
  std::vector<double> distances;
  for (const Landmark& landmark : landmarks)
    distances.push_back(landmark.prone.distance(landmark.supine));
  return statistics(std::move(distances));
}

std::vector<MappedLandmark> map_landmarks(const std::vector<Landmark>& landmarks,
                                          const PointMapper& prone, const PointMapper& supine) {
  std::vector<MappedLandmark> mapped;
  for (const Landmark& landmark : landmarks)
    mapped.push_back({landmark, prone.map(landmark.prone, Configuration::loaded),
                      supine.map(landmark.supine, Configuration::loaded)});
  return mapped;
}

ErrorStatistics inverse_consistency(const std::vector<Point<3>>& points, const PointMapper& from,
                                    const PointMapper& to) {
  std::vector<double> distances;
  for (const Point<3>& point : points) {
    const Point<3> there = to.to_loaded(from.to_unloaded(point));
    distances.push_back(from.to_loaded(to.to_unloaded(there)).distance(point));
  }
  return statistics(std::move(distances));
}

ErrorStatistics unloaded_error(const std::vector<Landmark>& landmarks, const PointMapper& prone,
                               const PointMapper& supine) {
  std::vector<double> distances;
  for (const MappedLandmark& landmark : map_landmarks(landmarks, prone, supine))
    distances.push_back(landmark.error());
  return statistics(std::move(distances));
}

std::string error_table(const std::vector<ErrorRow>& rows) {
  std::string table = format("%-30s %8s %8s %8s %8s\n", "Target registration error (mm)", "mean",
                             "std", "p95", "max");
  for (const ErrorRow& row : rows)
    table += format("%-30s %8.2f %8.2f %8.2f %8.2f\n", row.step.c_str(), row.error.mean,
                    row.error.std, row.error.p95, row.error.max);
  return table;
}

} // namespace prosup::evaluation
