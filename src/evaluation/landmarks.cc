#include "prosup/evaluation/landmarks.h"

#include <set>

#include "csv.h"
#include "prosup/core/error.h"
#include "prosup/core/text.h"
#include "text_input.h"

namespace prosup::evaluation {

std::vector<Landmark> parse_landmarks(const std::string& text, const std::string& name,
                                      Remarks& remarks) {
  const csv::Table table(as_utf8(text, name, remarks), name);
  const std::size_t id = table.id_column();
  const auto prone = table.point_columns("prone_", remarks),
             supine = table.point_columns("supine_", remarks);
  std::optional<csv::PointColumns> unloaded;
  if (table.find("unloaded_x") || table.find("unloaded_y") || table.find("unloaded_z"))
    unloaded = table.point_columns("unloaded_", remarks);

  std::vector<Landmark> landmarks;
  std::set<std::string> ids;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    Landmark landmark{table.text(row, id), table.point(row, prone), table.point(row, supine), {}};
    if (unloaded)
      landmark.unloaded = table.point(row, *unloaded);
    if (landmark.id.empty() || !ids.insert(landmark.id).second)
      throw Error("In " + table.where(row) + ": the landmark id '" + shown(landmark.id) + "' is " +
                  (landmark.id.empty() ? "empty" : "used twice") +
                  "; give each landmark an id of its own.");
    landmarks.push_back(std::move(landmark));
  }
  return landmarks;
}

std::vector<Landmark> read_landmarks(const std::filesystem::path& file, Remarks& remarks) {
  return parse_landmarks(read_file(file), file.string(), remarks);
}

std::vector<Landmark> read_landmarks(const std::filesystem::path& file) {
  Remarks untold;
  return read_landmarks(file, untold);
}

} // namespace prosup::evaluation
