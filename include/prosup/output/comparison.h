#ifndef PROSUP_OUTPUT_COMPARISON_H
#define PROSUP_OUTPUT_COMPARISON_H

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "prosup/evaluation/target_registration_error.h"

namespace prosup::output {

/// One run of a comparison. Quantities that are not known are not set.
struct ComparisonRow {
  std::string group, name; ///< a group is one series of the plot
  unsigned ranks = 1;      ///< or threads of a program that has no ranks
  std::string status;      ///< ok, not settled or failed
  std::string message;     ///< of a run that failed
  double seconds = 0.;     ///< wall time of the whole process: median of the repetitions
  double least_seconds = 0., most_seconds = 0.;
  std::optional<double> mesh_seconds, solve_seconds; ///< of its stages
  std::optional<double> memory;                      ///< peak, MiB
  std::optional<double> cells, steps;
  std::optional<evaluation::ErrorStatistics> error;          ///< mm
  std::optional<evaluation::ErrorStatistics> unloaded_error; ///< in the unloaded configuration
  std::optional<double> min_jacobian;                        ///< of the map from prone to supine
  std::optional<double> folded_fraction; ///< of the breast where that is not positive
};

/// A quantity that an axis of a plot can show: its name in parameter files and its label.
struct ComparisonQuantity {
  const char *name, *label;
  std::optional<double> (*value)(const ComparisonRow&);
};
const std::vector<ComparisonQuantity>& comparison_quantities();
/// The quantity of that name.
/// @throws Error that lists the names if there is none.
const ComparisonQuantity& comparison_quantity(const std::string& name);

/// A comparison: what was compared, on which machine, and the results.
struct Comparison {
  std::string name, title;
  std::vector<std::pair<std::string, std::string>> machine; ///< of what, and which
  std::vector<ComparisonRow> rows;
  std::string x_axis;              ///< name of a quantity
  std::string x_label;             ///< empty: that of the quantity
  std::vector<std::string> y_axes; ///< a chart each
  bool has_front = false;          ///< rows that no other beats in both are joined
};

/// Writes `<name>.csv`, `<name>.md`, `<name>.svg` and `summary.json`.
/// @throws Error if a file cannot be written or a number is not finite.
void write_comparison(const Comparison& comparison, const std::filesystem::path& folder);

/// The table as Markdown.
std::string comparison_table(const std::vector<ComparisonRow>& rows);

/// Models of time and memory, fitted to the rows of each group with at least three meshes. With n
/// thousand cells and r ranks they are a n^b r^c for the time of meshing and for that of solving, a
/// + b n for the remaining time, and a r + b n for the memory. Markdown; empty if no group has
/// three meshes.
std::string cost_models(const std::vector<ComparisonRow>& rows);

} // namespace prosup::output

#endif
