#include "prosup/evaluation/landmarks_csv.h"

#include "csv.h"
#include "prosup/core/log.h"
#include "prosup/core/text_file.h"

namespace prosup::evaluation {

void write_landmarks(const std::vector<MappedLandmark>& landmarks,
                     const std::filesystem::path& file) {
  std::string text = "id";
  for (const char* position : {"prone", "supine", "unloaded_from_prone", "unloaded_from_supine"})
    text += format(",%s_x,%s_y,%s_z", position, position, position);
  text += ",tre_mm\n";
  for (const MappedLandmark& row : landmarks) {
    const std::string what = "landmark '" + row.landmark.id + "'";
    text += csv::quoted(row.landmark.id);
    for (const Point<3>& position : {row.landmark.prone, row.landmark.supine,
                                     row.from_prone.position, row.from_supine.position})
      text += "," + csv::coordinates(position, what);
    text += format(",%.6f\n", row.error());
  }
  write_text_file(text, file);
}

} // namespace prosup::evaluation
