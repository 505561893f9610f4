#include "prosup/evaluation/landmarks.h"

#include <set>

#include "csv.h"
#include "prosup/core/error.h"

namespace prosup::evaluation {

std::vector<Landmark> read_landmarks(const std::filesystem::path& file) {
  const csv::Table table(file);
  const std::size_t id = table.column("id");
  const auto prone = table.point_columns("prone_"), supine = table.point_columns("supine_");
  std::optional<std::array<std::size_t, 3>> unloaded;
  if (table.find("unloaded_x") || table.find("unloaded_y") || table.find("unloaded_z"))
    unloaded = table.point_columns("unloaded_");

  std::vector<Landmark> landmarks;
  std::set<std::string> ids;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    Landmark landmark{table.text(row, id), table.point(row, prone), table.point(row, supine), {}};
    if (unloaded)
      landmark.unloaded = table.point(row, *unloaded);
    if (landmark.id.empty() || !ids.insert(landmark.id).second)
      throw Error("In " + table.where(row) + ": the landmark id '" + landmark.id + "' is " +
                  (landmark.id.empty() ? "empty" : "used twice") +
                  "; give each landmark an id of its own.");
    landmarks.push_back(std::move(landmark));
  }
  return landmarks;
}

} // namespace prosup::evaluation
