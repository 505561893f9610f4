#ifndef PROSUP_EVALUATION_LANDMARKS_CSV_H
#define PROSUP_EVALUATION_LANDMARKS_CSV_H

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/core/position.h"
#include "prosup/evaluation/target_registration_error.h"

namespace prosup::evaluation {

/// Writes the landmarks of a result: id, prone, supine, unloaded_from_prone and
/// unloaded_from_supine (x, y, z each; LPS mm), and tre_mm, the distance between the last two; if
/// all have error bars, these too: sd_x, sd_y, sd_z and radius_95, mm.
/// @throws Error if a coordinate is not finite or the file cannot be written.
void write_landmarks(const std::vector<MappedLandmark>& landmarks,
                     const std::filesystem::path& file);

/// The error of one landmark of a result, mm.
struct LandmarkError {
  std::string id;
  double error;
  std::optional<PerPosition<Point<3>>> unloaded; ///< from both images, if the file has it; LPS mm
};

/// The errors (tre_mm) in a file of the function above, and where they are.
/// @throws Error if it cannot be read or has no such column.
std::vector<LandmarkError> read_errors(const std::filesystem::path& file);

/// Writes landmarks in the format of read_landmarks(), to 1e-6 mm, with the unloaded positions
/// if all are known.
/// @throws Error if a coordinate is not finite or the file cannot be written.
void write_landmarks(const std::vector<Landmark>& landmarks, const std::filesystem::path& file);

} // namespace prosup::evaluation

#endif
