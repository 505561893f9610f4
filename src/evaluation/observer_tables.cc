#include "prosup/core/csv_cell.h"
#include "prosup/core/log.h"
#include "prosup/core/text_file.h"
#include "prosup/evaluation/observers.h"

#include "csv.h"

namespace prosup::evaluation {

namespace {

const char* name(Selection selection) {
  return selection == Selection::all ? "all" : "reliable";
}

std::string csv_row(const std::string& quantity, const std::string& observer, Selection selection,
                    const ErrorStatistics& s) {
  std::string row =
      quantity + "," + csv_quoted(observer) + "," + name(selection) + format(",%zu", s.n);
  // Without a landmark there is no mean, which is not the same as a mean of 0.
  return row + (s.n > 0 ? format(",%.4f,%.4f,%.4f\n", s.mean, s.std, s.max) : ",,,\n");
}

/// Mean, max. and std. in the order of the paper's tables.
std::string cells(const ErrorStatistics& s) {
  return s.n > 0 ? format(" %.1f | %.1f | %.1f |", s.mean, s.max, s.std) : " - | - | - |";
}

} // namespace

void write_observer_tables(const std::vector<ObserverRow>& rows,
                           const std::vector<ObserverDistance>& distances,
                           const std::filesystem::path& file) {
  std::string text = std::string(observer_tables_header) + "\n";
  for (const ObserverRow& row : rows) {
    text += csv_row("initial_distance", row.observer, row.selection, row.initial);
    text += csv_row("registration_error", row.observer, row.selection, row.error);
  }
  for (const ObserverDistance& d : distances) {
    const std::string quantity = "observer_distance_" + d.state;
    const std::string pair = d.first + " - " + d.second;
    text += csv_row(quantity, pair, Selection::all, d.all);
    text += csv_row(quantity, pair, Selection::reliable, d.reliable);
  }
  write_text_file(text, file);
}

std::string observer_tables(const std::vector<ObserverRow>& rows,
                            const std::vector<ObserverDistance>& distances) {
  std::string text = "Target registration error (mm)\n\n"
                     "| observer | landmarks | n | initial mean | max | std | registered mean | "
                     "max | std |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const ObserverRow& row : rows)
    text += "| " + row.observer + " | " + name(row.selection) + format(" | %zu |", row.error.n) +
            cells(row.initial) + cells(row.error) + "\n";
  if (distances.empty())
    return text;
  text += "\nDistance between observers (mm)\n\n"
          "| observers | state | mean | max | std | reliable mean | max | std | landmarks | "
          "outliers |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const ObserverDistance& d : distances)
    text += "| " + d.first + " - " + d.second + " | " + d.state + " |" + cells(d.all) +
            cells(d.reliable) + format(" %zu | %zu |\n", d.all.n, d.all.n - d.reliable.n);
  return text;
}

} // namespace prosup::evaluation
