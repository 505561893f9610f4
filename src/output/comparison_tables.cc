#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison_pictures.h"
#include "prosup/core/csv_cell.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text_file.h"
#include "prosup/core/version.h"
#include "prosup/output/comparison.h"

namespace prosup::output {

namespace {

using Json = nlohmann::ordered_json;
using Row = ComparisonRow;

/// A figure of a row, if it has it.
struct Column {
  const char *csv, *markdown; ///< headers; without the second it is in the CSV file only
  int digits;                 ///< behind the point, in Markdown
  std::optional<double> (*value)(const Row&);
};

using Errors = std::optional<evaluation::ErrorStatistics>;

std::optional<double> part(const Errors& errors, double evaluation::ErrorStatistics::*member) {
  return errors ? std::optional<double>((*errors).*member) : std::nullopt;
}

using Statistics = evaluation::ErrorStatistics;
using Value = std::optional<double>;

const Column columns[] = {
    {"time_s", "time, s", 1, [](const Row& r) { return Value(r.seconds); }},
    {"time_least_s", nullptr, 0, [](const Row& r) { return Value(r.least_seconds); }},
    {"time_most_s", nullptr, 0, [](const Row& r) { return Value(r.most_seconds); }},
    {"mesh_s", "mesh, s", 1, [](const Row& r) { return r.mesh_seconds; }},
    {"solve_s", "solve, s", 1, [](const Row& r) { return r.solve_seconds; }},
    {"mean_mm", "mean, mm", 3, [](const Row& r) { return part(r.error, &Statistics::mean); }},
    {"std_mm", nullptr, 0, [](const Row& r) { return part(r.error, &Statistics::std); }},
    {"p95_mm", "p95", 2, [](const Row& r) { return part(r.error, &Statistics::p95); }},
    {"max_mm", "max", 2, [](const Row& r) { return part(r.error, &Statistics::max); }},
    {"unloaded_mean_mm", "unloaded mean, mm", 3,
     [](const Row& r) { return part(r.unloaded_error, &Statistics::mean); }},
    {"unloaded_max_mm", "unloaded max", 2,
     [](const Row& r) { return part(r.unloaded_error, &Statistics::max); }},
    {"min_jacobian", "min J", 3, [](const Row& r) { return r.min_jacobian; }},
    {"folded_fraction", "folded", 4, [](const Row& r) { return r.folded_fraction; }},
    {"cells", "cells", 0, [](const Row& r) { return r.cells; }},
    {"steps", "steps", 0, [](const Row& r) { return r.steps; }},
    {"memory_MiB", "memory, MiB", 0, [](const Row& r) { return r.memory; }}};

/// Whether some row has a value there.
bool any(const std::vector<Row>& rows, const Column& column) {
  for (const Row& row : rows)
    if (row.status != "failed" && column.value(row))
      return true;
  return false;
}

std::string csv_of(const std::vector<Row>& rows) {
  std::string text = "group,name,ranks,status";
  for (const Column& column : columns)
    text += std::string(",") + column.csv;
  text += ",message\n";
  for (const Row& row : rows) {
    text +=
        csv_quoted(row.group) + "," + csv_quoted(row.name) + format(",%u,", row.ranks) + row.status;
    for (const Column& column : columns) {
      const Value value = row.status == "failed" ? Value() : column.value(row);
      text += value ? format(",%.6g", *value) : ",";
    }
    text += "," + csv_words(row.message) + "\n";
  }
  return text;
}

Json json_of(const Comparison& comparison) {
  Json json;
  json["version"] = version();
  json["command"] = "compare";
  json["title"] = comparison.title;
  for (const auto& [what, which] : comparison.machine)
    json["machine"][what] = which;
  json["runs"] = Json::array();
  for (const Row& row : comparison.rows) {
    Json run{
        {"group", row.group}, {"name", row.name}, {"ranks", row.ranks}, {"status", row.status}};
    if (!row.message.empty())
      run["message"] = row.message;
    if (row.status != "failed")
      for (const Column& column : columns)
        if (const Value value = column.value(row))
          run[column.csv] = *value;
    json["runs"].push_back(run);
  }
  return json;
}

void require_finite(const Row& row) {
  for (const Column& column : columns)
    if (const Value value = column.value(row); value && !std::isfinite(*value))
      throw Error("The figure '" + std::string(column.csv) + "' of the run '" + row.group + "/" +
                  row.name + "' is not a finite number; look at its log.");
}

std::string markdown_of(const Comparison& comparison) {
  std::string text = "# " + comparison.title + "\n\n" + comparison_table(comparison.rows) + "\n";
  const std::string models = cost_models(comparison.rows);
  if (!models.empty())
    text += models + "\n";
  text += "![" + comparison.title + "](" + comparison.name + ".svg)\n\n| machine | |\n|---|---|\n";
  for (const auto& [what, which] : comparison.machine)
    text += "| " + what + " | " + which + " |\n";
  return text;
}

} // namespace

std::string comparison_table(const std::vector<Row>& rows) {
  std::string text = "| method | run | ranks |", rule = "|---|---|---|";
  for (const Column& column : columns)
    if (column.markdown != nullptr && any(rows, column)) {
      text += std::string(" ") + column.markdown + " |";
      rule += "---|";
    }
  text += " status |\n" + rule + "---|\n";
  for (const Row& row : rows) {
    text += "| " + row.group + " | " + row.name + format(" | %u |", row.ranks);
    for (const Column& column : columns)
      if (column.markdown != nullptr && any(rows, column)) {
        const Value value = row.status == "failed" ? Value() : column.value(row);
        text += value ? format(" %.*f |", column.digits, *value) : " |";
      }
    text += " " + row.status + " |\n";
  }
  std::string messages;
  for (const Row& row : rows)
    if (!row.message.empty())
      messages += format("- %s/%s, %u: %s\n", row.group.c_str(), row.name.c_str(), row.ranks,
                         row.message.c_str());
  return text + (messages.empty() ? "" : "\n" + messages);
}

void write_comparison(const Comparison& comparison, const std::filesystem::path& folder) {
  for (const Row& row : comparison.rows)
    require_finite(row);
  write_text_file(csv_of(comparison.rows), folder / (comparison.name + ".csv"));
  write_text_file(markdown_of(comparison), folder / (comparison.name + ".md"));
  write_text_file(comparison_picture(comparison), folder / (comparison.name + ".svg"));
  write_text_file(json_of(comparison).dump(2, ' ', false, Json::error_handler_t::replace) + "\n",
                  folder / "summary.json");
}

} // namespace prosup::output
