#include "comparison_pictures.h"

#include <algorithm>
#include <cstdlib>

#include "line_chart.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::output {

namespace {

using Row = ComparisonRow;
using Value = std::optional<double>;
using evaluation::ErrorStatistics;

/// Colours that differ for colour-blind readers as well (Okabe, Ito), then others.
const char* const colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8a6d00", "#56b4e9",
                               "#000000", "#7b3294", "#a6611a", "#666666", "#b2182b", "#1b7837"};
constexpr unsigned n_colours = sizeof(colours) / sizeof(colours[0]);

Value error_part(const Row& row, double ErrorStatistics::*member) {
  return row.error ? Value((*row.error).*member) : std::nullopt;
}

/// The name of a run as a number, if it is one: "7" or "7 mm".
Value number_in(const std::string& name) {
  char* end = nullptr;
  const double value = std::strtod(name.c_str(), &end);
  return end == name.c_str() ? Value() : Value(value);
}

/// The series that a row belongs to: its group, and what else differs from point to
/// point but is not on the axis.
std::string series_name(const Comparison& comparison, const Row& row) {
  if (comparison.x_axis == "ranks")
    return row.group + "/" + row.name;
  const bool several_ranks =
      std::any_of(comparison.rows.begin(), comparison.rows.end(),
                  [&](const Row& other) { return other.ranks != row.ranks; });
  return row.group +
         (several_ranks ? format(", %u rank%s", row.ranks, row.ranks > 1 ? "s" : "") : "");
}

/// Points of each series, in the order in which they appear.
std::vector<Series> series_of(const Comparison& comparison, const ComparisonQuantity& x,
                              const ComparisonQuantity& y) {
  std::vector<Series> series;
  for (const Row& row : comparison.rows) {
    const std::string name = series_name(comparison, row);
    auto found =
        std::find_if(series.begin(), series.end(), [&](const Series& s) { return s.name == name; });
    if (found == series.end()) {
      const auto i = static_cast<unsigned>(series.size());
      series.push_back({name, colours[i % n_colours], {}, Style::markers, i, {}});
      found = series.end() - 1;
    }
    const Value at = x.value(row), value = y.value(row);
    if (row.status == "failed" || !at || !value || !(*at > 0.) || !(*value > 0.))
      continue;
    found->points.emplace_back(*at, *value);
    // Where x tells which run it is, its name would say so twice.
    if (comparison.has_front)
      found->labels.push_back(row.name);
  }
  series.erase(std::remove_if(series.begin(), series.end(),
                              [](const Series& s) { return s.points.empty(); }),
               series.end());
  return series;
}

/// The points that no other point is left of and below, from left to right.
Series front_of(const std::vector<Series>& series) {
  Series front{"front", "#999999", {}, Style::dashes, 0, {}};
  std::vector<std::pair<double, double>> points;
  for (const Series& s : series)
    points.insert(points.end(), s.points.begin(), s.points.end());
  std::sort(points.begin(), points.end());
  for (const auto& point : points)
    if (front.points.empty() || point.second < front.points.back().second)
      front.points.push_back(point);
  return front;
}

} // namespace

const std::vector<ComparisonQuantity>& comparison_quantities() {
  static const std::vector<ComparisonQuantity> quantities{
      {"name", "name of the run", [](const Row& r) { return number_in(r.name); }},
      {"time", "wall time, s", [](const Row& r) { return Value(r.seconds); }},
      {"solve time", "time of the solver, s", [](const Row& r) { return r.solve_seconds; }},
      {"mean", "mean error, mm",
       [](const Row& r) { return error_part(r, &ErrorStatistics::mean); }},
      {"p95", "95th percentile of the error, mm",
       [](const Row& r) { return error_part(r, &ErrorStatistics::p95); }},
      {"max", "largest error, mm",
       [](const Row& r) { return error_part(r, &ErrorStatistics::max); }},
      {"cells", "cells", [](const Row& r) { return r.cells; }},
      {"ranks", "ranks", [](const Row& r) { return Value(r.ranks); }},
      {"memory", "memory, MiB", [](const Row& r) { return r.memory; }}};
  return quantities;
}

const ComparisonQuantity& comparison_quantity(const std::string& name) {
  std::string names;
  for (const ComparisonQuantity& quantity : comparison_quantities()) {
    if (quantity.name == name)
      return quantity;
    names += (names.empty() ? "" : ", ") + std::string(quantity.name);
  }
  throw Error("A plot cannot show '" + name + "'; choose from " + names + ".");
}

std::string comparison_picture(const Comparison& comparison) {
  const ComparisonQuantity& x = comparison_quantity(comparison.x_axis);
  std::vector<Chart> charts;
  for (const std::string& name : comparison.y_axes) {
    const ComparisonQuantity& y = comparison_quantity(name);
    Chart chart{y.label, series_of(comparison, x, y)};
    if (comparison.has_front)
      chart.series.insert(chart.series.begin(), front_of(chart.series));
    charts.push_back(std::move(chart));
  }
  return svg_of(charts, comparison.title, comparison.x_label.empty() ? x.label : comparison.x_label,
                Scale::logarithmic);
}

} // namespace prosup::output
