#include "prosup/evaluation/landmarks_csv.h"

#include <algorithm>

#include "csv.h"
#include "prosup/core/csv_cell.h"
#include "prosup/core/log.h"
#include "prosup/core/text_file.h"
#include "text_input.h"

namespace prosup::evaluation {

namespace {

std::string header(const std::vector<const char*>& positions) {
  std::string text = "id";
  for (const char* position : positions)
    text += format(",%s_x,%s_y,%s_z", position, position, position);
  return text;
}

std::string row(const std::string& id, const std::vector<Point<3>>& positions) {
  std::string text = csv_quoted(id);
  for (const Point<3>& position : positions)
    text += "," + csv::coordinates(position, "landmark '" + id + "'");
  return text;
}

} // namespace

void write_landmarks(const std::vector<MappedLandmark>& landmarks,
                     const std::filesystem::path& file) {
  const bool has_error_bars =
      std::all_of(landmarks.begin(), landmarks.end(),
                  [](const MappedLandmark& l) { return l.error_bar.has_value(); });
  std::string text = header({"prone", "supine", "unloaded_from_prone", "unloaded_from_supine"}) +
                     ",tre_mm" + (has_error_bars ? ",sd_x,sd_y,sd_z,radius_95" : "") + "\n";
  for (const MappedLandmark& mapped : landmarks) {
    const std::string& id = mapped.landmark.id;
    text += row(id, {mapped.landmark.prone, mapped.landmark.supine, mapped.from_prone.position,
                     mapped.from_supine.position}) +
            format(",%.6f", mapped.error()) +
            (has_error_bars ? "," + csv::error_values(*mapped.error_bar, "landmark '" + id + "'")
                            : "") +
            "\n";
  }
  write_text_file(text, file);
}

std::vector<LandmarkError> read_errors(const std::filesystem::path& file) {
  const csv::Table table(read_file(file), file.string());
  const std::size_t id = table.id_column(), error = table.column("tre");
  std::optional<PerPosition<csv::PointColumns>> unloaded;
  if (table.find("unloaded_from_prone_x")) {
    Remarks none;
    unloaded = {table.point_columns("unloaded_from_prone_", none),
                table.point_columns("unloaded_from_supine_", none)};
  }
  std::vector<LandmarkError> errors;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    errors.push_back({table.text(row, id),
                      csv::parse_number(table.text(row, error), table.where(row), "tre_mm"),
                      {}});
    if (unloaded)
      errors.back().unloaded = {table.point(row, unloaded->prone),
                                table.point(row, unloaded->supine)};
  }
  return errors;
}

void write_landmarks(const std::vector<Landmark>& landmarks, const std::filesystem::path& file) {
  const bool unloaded = std::all_of(landmarks.begin(), landmarks.end(),
                                    [](const Landmark& l) { return l.unloaded.has_value(); });
  std::vector<const char*> columns{"prone", "supine"};
  if (unloaded)
    columns.push_back("unloaded");
  std::string text = header(columns) + "\n";
  for (const Landmark& landmark : landmarks) {
    std::vector<Point<3>> positions{landmark.prone, landmark.supine};
    if (unloaded)
      positions.push_back(*landmark.unloaded);
    text += row(landmark.id, positions) + "\n";
  }
  write_text_file(text, file);
}

} // namespace prosup::evaluation
