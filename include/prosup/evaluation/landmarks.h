#ifndef PROSUP_EVALUATION_LANDMARKS_H
#define PROSUP_EVALUATION_LANDMARKS_H

#include <deal.II/base/point.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/core/remarks.h"

namespace prosup::evaluation {

using dealii::Point;

/// An anatomical point that is visible in both images, LPS mm. Its unloaded position is known
/// only in numerical phantoms.
struct Landmark {
  std::string id;
  Point<3> prone, supine;
  std::optional<Point<3>> unloaded;
};

/// Reads landmarks from a CSV file. The header must name the columns id, prone_x, prone_y,
/// prone_z, supine_x, supine_y and supine_z, in any order, and all or none of unloaded_x,
/// unloaded_y and unloaded_z. Other columns are ignored; docs/points.md has what else is
/// understood. What was turned or assumed goes to `remarks`.
/// @throws Error that names the file, the line and what is allowed, if the file is missing or
/// empty, a column is missing or occurs twice, a row has too many or too few values, a number
/// is not finite, or an id occurs twice.
std::vector<Landmark> read_landmarks(const std::filesystem::path& file, Remarks& remarks);
std::vector<Landmark> read_landmarks(const std::filesystem::path& file);

/// Reads the `text` of landmarks that came from the file `name`. @throws Error as read_landmarks().
std::vector<Landmark> parse_landmarks(const std::string& text, const std::string& name,
                                      Remarks& remarks);

} // namespace prosup::evaluation

#endif
