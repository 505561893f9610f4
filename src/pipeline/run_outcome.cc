#include "run_outcome.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/evaluation/field_error.h"
#include "prosup/image/image_io.h"
#include "prosup/pipeline/finished_result.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Row = output::ComparisonRow;

namespace {

constexpr int timed_out = 124, first_signal = 128; // exit codes of timeout

/// The sum of a figure of both states; nothing if neither has it.
std::optional<double> sum_of_states(const Json& states, const char* figure) {
  std::optional<double> sum;
  for (const auto& state : states)
    if (state.contains(figure))
      sum = sum.value_or(0.) + state.at(figure).get<double>();
  return sum;
}

evaluation::ErrorStatistics statistics_of(const Json& json) {
  return {json.at("mean"), json.at("std"), json.at("max"), json.at("p95"), json.at("n")};
}

void read_summary(const Json& summary, Row& row) {
  if (summary.contains("mesh"))
    row.cells = sum_of_states(summary.at("mesh"), "cells");
  if (summary.contains("steps"))
    row.steps = summary.at("steps").get<double>();
  if (summary.contains("peak_memory"))
    row.memory = summary.at("peak_memory").get<double>();
  if (summary.contains("min_jacobian"))
    for (const auto& smallest : summary.at("min_jacobian"))
      row.min_jacobian = std::min(row.min_jacobian.value_or(smallest), smallest.get<double>());
  const Json& time = summary.at("time");
  if (time.contains("mesh"))
    row.mesh_seconds = time.at("mesh").get<double>();
  for (const char* stage : {"unloading", "material", "image_forces"})
    if (time.contains(stage))
      row.solve_seconds = row.solve_seconds.value_or(0.) + time.at(stage).get<double>();
}

/// The last line of a file, or the last one that starts with `start`.
std::string last_line(const fs::path& file, const std::string& start = "") {
  std::ifstream stream(file);
  std::string last;
  for (std::string line; std::getline(stream, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos &&
        line.compare(0, start.size(), start) == 0)
      last = line.substr(start.size());
  return last;
}

} // namespace

void measure_field(const fs::path& field, const Yardstick& yardstick, Row& row) {
  const image::VectorImage displacement = image::read_displacement(field);
  if (!yardstick.landmarks.empty())
    row.error = evaluation::field_error(yardstick.landmarks, displacement);
  const evaluation::FieldJacobian jacobian =
      evaluation::field_jacobian(displacement, yardstick.breast);
  row.min_jacobian = jacobian.min;
  row.folded_fraction = jacobian.folded_fraction;
}

void measure_result(const fs::path& result, bool is_registration, const Yardstick& yardstick,
                    Row& row) {
  const Json summary = Json::parse(std::ifstream(result / "summary.json"), nullptr, false);
  if (summary.is_discarded())
    throw Error("The run left no summary.json that can be read.");
  read_summary(summary, row);
  if (!is_registration) {
    if (summary.contains("tre"))
      row.error = statistics_of(summary.at("tre").at("unloaded"));
    return;
  }
  measure_field(result / "prone_to_supine.nrrd", yardstick, row);
  // A method without meshes has no unloaded positions but those of its fields.
  if (!yardstick.landmarks.empty() && fs::exists(result / "prone_loaded.vtu"))
    row.unloaded_error = evaluation::unloaded_error(
        yardstick.landmarks, read_mapper(result, "prone"), read_mapper(result, "supine"));
}

std::string reason_of_failure(const ChildResult& child, const fs::path& log) {
  if (child.exit_code == timed_out)
    return format("ended after %.0f s, the 'Comparison/Time limit'", child.wall_seconds);
  // mpirun says more behind the sentence of prosup.
  std::string said;
  for (const auto& [end, start] :
       {std::pair(".err", "prosup: "), std::pair(".err", ""), std::pair(".out", "")})
    if (said.empty())
      said = last_line(log.string() + end, start);
  if (child.exit_code > first_signal)
    return format("ended by signal %d; its last line was: %s", child.exit_code - first_signal,
                  said.c_str());
  return said.empty() ? format("ended with exit code %d and said nothing", child.exit_code) : said;
}

} // namespace prosup::pipeline
