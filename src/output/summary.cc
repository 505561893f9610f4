#include "prosup/output/summary.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "prosup/core/error.h"
#include "prosup/core/text_file.h"
#include "prosup/core/version.h"
#include "prosup/mesh/deformation.h"
#include "prosup/mesh/quality.h"

namespace prosup::output {

namespace {

// Keeps the entries in the order in which they are written below.
using Json = nlohmann::ordered_json;

template <class T>
void set(Json& json, const char* name, const std::optional<T>& value) {
  if (value)
    json[name] = *value;
}

void set(Json& json, const char* name, const std::optional<evaluation::ErrorStatistics>& error) {
  if (error)
    json[name] = {{"mean", error->mean},
                  {"std", error->std},
                  {"max", error->max},
                  {"p95", error->p95},
                  {"n", error->n}};
}

void set_breast(Json& json, const char* name, const std::optional<BreastSummary>& breast) {
  if (!breast)
    return;
  json["mesh"][name] = {
      {"cells", breast->n_cells}, {"nodes", breast->n_nodes}, {"min_quality", breast->min_quality}};
  set(json["min_jacobian"], name, breast->min_jacobian);
  set(json["max_jacobian"], name, breast->max_jacobian);
}

void set(Json& json, const char* name, const std::optional<PreparationSummary>& scan) {
  if (scan)
    json["preparation"][name] = {{"contrast", scan->contrast},
                                 {"fat_ml", scan->fat_volume},
                                 {"gland_ml", scan->gland_volume},
                                 {"weak_chest_edge", scan->weak_edge},
                                 {"bridged_chest_cm2", scan->bridged_area},
                                 {"odd_chest_cm2", scan->odd_area},
                                 {"unknown_contact_cm2", scan->unknown_contact},
                                 {"tissue_separation", scan->separation},
                                 {"doubts", scan->doubts}};
}

void set(Json& json, const char* name, const std::optional<AlignmentSummary>& alignment) {
  if (!alignment)
    return;
  json[name] = {{"method", alignment->method},
                {"translation", alignment->translation},
                {"rotation_degrees", alignment->rotation_degrees},
                {"surface_distance",
                 {{"before", alignment->surface_before}, {"after", alignment->surface_after}}}};
  if (alignment->information)
    json[name]["mutual_information"] = {{"before", (*alignment->information)[0]},
                                        {"after", (*alignment->information)[1]}};
}

Json as_json(const QualitySummary& quality) {
  Json json{{"verdict", quality.verdict}, {"reasons", quality.reasons}};
  for (const auto& [name, value] : quality.figures) {
    std::string path = "/" + name;
    std::replace(path.begin(), path.end(), '.', '/');
    json[Json::json_pointer(path)] = value;
  }
  return json;
}

Json as_json(const SimilarityEntry& entry) {
  return {{"stage", entry.stage},
          {"level_mm", entry.level_mm},
          {"iteration", entry.iteration},
          {"value", entry.value}};
}

Json as_json(const Summary& summary) {
  Json json;
  json["version"] = version();
  json["command"] = summary.command;
  json["ranks"] = summary.ranks;
  json["converged"] = summary.converged;
  if (summary.quality)
    json["quality"] = as_json(*summary.quality);
  for (const Position position : both_positions)
    set_breast(json, name_of(position), summary.breasts[position]);
  for (const Position position : both_positions)
    set(json, name_of(position), summary.preparation[position]);
  set(json, "alignment", summary.alignment);
  set(json, "steps", summary.steps);
  set(json, "metric", summary.metric);
  set(json["material"], "shear_modulus", summary.shear_modulus);
  set(json["material"], "lambda", summary.lambda);
  set(json["material"], "poisson_ratio", summary.poisson_ratio);
  set(json["material"], "gland_ratio", summary.gland_ratio);
  set(json["material"], "skin_stiffness", summary.skin_stiffness);
  set(json["material"], "chest_stiffness", summary.chest_stiffness);
  set(json["material"], "lateral_chest_ratio", summary.lateral_chest_ratio);
  if (summary.cut_plane_stiffness)
    for (const Position position : both_positions)
      json["material"]["cut_plane_stiffness"][name_of(position)] =
          (*summary.cut_plane_stiffness)[position];
  set(json["material"], "supine_tilt", summary.supine_tilt);
  set(json["tre"], "initial", summary.tre.initial);
  set(json["tre"], "unloaded", summary.tre.unloaded);
  set(json["tre"], "material", summary.tre.material);
  set(json["tre"], "image_forces", summary.tre.image_forces);
  set(json, "inverse_consistency", summary.inverse_consistency);
  set(json["time"], "mesh", summary.time.mesh);
  set(json["time"], "unloading", summary.time.unloading);
  set(json["time"], "material", summary.time.material);
  set(json["time"], "image_forces", summary.time.image_forces);
  json["time"]["total"] = summary.time.total;
  json["peak_memory"] = summary.peak_memory;
  json["warnings"] = summary.warnings;
  for (const SimilarityEntry& entry : summary.similarity)
    json["similarity"].push_back(as_json(entry));
  for (const char* group : {"mesh", "min_jacobian", "max_jacobian", "material", "tre"})
    if (json.contains(group) && json[group].is_null())
      json.erase(group);
  return json;
}

/// JSON has no numbers that are not finite; the library would write null.
void require_finite(const Json& json, const std::string& name) {
  if (json.is_number_float() && !std::isfinite(json.get<double>()))
    throw Error("The entry '" + name +
                "' of the summary is not a finite number and was not written; look at the log for "
                "the stage that failed.");
  if (!json.is_structured())
    return;
  for (const auto& [key, value] : json.items())
    require_finite(value, name.empty() ? key : name + "." + key);
}

} // namespace

BreastSummary summarize(const mesh::UnloadedMesh& mesh) {
  const mesh::MeshQuality quality = mesh::measure_quality(mesh.mesh);
  const mesh::JacobianRange jacobian = mesh::jacobian_range(mesh);
  BreastSummary summary;
  summary.n_cells = quality.n_cells;
  summary.n_nodes = quality.n_nodes;
  summary.min_quality = quality.min_quality;
  summary.min_jacobian = jacobian.min;
  summary.max_jacobian = jacobian.max;
  return summary;
}

void write_summary(const Summary& summary, const std::filesystem::path& file) {
  const Json json = as_json(summary);
  require_finite(json, "");
  write_text_file(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n", file);
}

std::string error_table(const Summary& summary) {
  namespace step = evaluation::step_name;
  std::vector<evaluation::ErrorRow> rows;
  const auto add = [&](const char* name, const auto& error) {
    if (error)
      rows.push_back({name, *error});
  };
  add(step::initial, summary.tre.initial);
  add(step::unloaded, summary.tre.unloaded);
  add(step::material, summary.tre.material);
  add(step::image_forces, summary.tre.image_forces);
  return rows.empty() ? std::string() : evaluation::error_table(rows);
}

std::string verdict_text(const Summary& summary) {
  if (!summary.quality)
    return {};
  std::string text = "Verdict: " + summary.quality->verdict;
  for (const std::string& reason : summary.quality->reasons)
    text += "\n  - " + reason;
  return text;
}

} // namespace prosup::output
