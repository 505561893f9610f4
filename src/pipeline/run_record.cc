#include "run_record.h"

#include <nlohmann/json.hpp>

#include "prosup/core/error.h"

namespace prosup::evaluation {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ErrorStatistics, mean, std, max, p95, n)

} // namespace prosup::evaluation

namespace prosup::registration {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Agreement::Intensities, correlation, local_correlation,
                                   mutual_information)

} // namespace prosup::registration

namespace prosup::pipeline {

using Json = nlohmann::json;

namespace {

/// Calls `visit` with the name and the place of each value that is kept.
template <typename Summary, typename Visitor>
void for_each_value(Summary& summary, const Visitor& visit) {
  visit("steps", summary.steps);
  visit("initial", summary.tre.initial);
  visit("unloaded", summary.tre.unloaded);
  visit("material", summary.tre.material);
  visit("image_forces", summary.tre.image_forces);
  visit("mesh_seconds", summary.time.mesh);
  visit("unloading_seconds", summary.time.unloading);
  visit("material_seconds", summary.time.material);
  visit("image_forces_seconds", summary.time.image_forces);
}

template <typename Agreement, typename Visitor>
void for_each_value_of_agreement(Agreement& agreement, const Visitor& visit) {
  visit("compared_share", agreement.compared_share);
  visit("volume_ratio", agreement.volume_ratio);
  visit("breast_dice", agreement.breast_dice);
  visit("gland_dice", agreement.gland_dice);
  visit("skin_distance", agreement.skin_distance);
  visit("skin_p95", agreement.skin_p95);
  visit("outside_share", agreement.outside_share);
  visit("intensities", agreement.intensities);
}

/// Calls `visit` with the name and the place of the agreement after each stage.
template <typename Quality, typename Visitor>
void for_each_agreement(Quality& quality, const Visitor& visit) {
  visit("unloaded", quality.unloaded);
  visit("material", quality.material);
  visit("image_forces", quality.image_forces);
}

template <typename Alignment, typename Visitor>
void for_each_value_of_alignment(Alignment& alignment, const Visitor& visit) {
  visit("method", alignment.method);
  visit("translation", alignment.translation);
  visit("rotation", alignment.rotation_degrees);
  visit("before", alignment.surface_before);
  visit("after", alignment.surface_after);
  visit("information", alignment.information);
}

template <typename Entry, typename Visitor>
void for_each_value_of_entry(Entry& entry, const Visitor& visit) {
  visit("stage", entry.stage);
  visit("level", entry.level_mm);
  visit("iteration", entry.iteration);
  visit("seconds", entry.seconds);
  visit("similarity", entry.similarity);
  visit("shear_modulus", entry.shear_modulus);
  visit("poisson_ratio", entry.poisson_ratio);
  visit("gland_ratio", entry.gland_ratio);
  visit("chest_stiffness", entry.chest_stiffness);
  visit("force_weight", entry.force_weight);
  visit("error", entry.error);
}

struct Writer {
  Json& json;
  template <typename Value>
  void operator()(const char* name, const Value& value) const {
    json[name] = value;
  }
  template <typename Value>
  void operator()(const char* name, const std::optional<Value>& value) const {
    if (value)
      json[name] = *value;
  }
};

struct Reader {
  const Json& json;
  template <typename Value>
  void operator()(const char* name, Value& value) const {
    json.at(name).get_to(value);
  }
  template <typename Value>
  void operator()(const char* name, std::optional<Value>& value) const {
    if (json.contains(name))
      value = json.at(name).get<Value>();
  }
};

} // namespace

std::string record_of(const output::Summary& summary, const registration::Quality& quality,
                      const std::vector<output::ConvergenceEntry>& convergence) {
  Json json;
  for_each_value(summary, Writer{json});
  json["at_bound"] = quality.at_bound;
  for_each_agreement(quality, [&](const char* name, const auto& agreement) {
    if (agreement)
      for_each_value_of_agreement(*agreement, Writer{json["agreement"][name]});
  });
  if (summary.alignment)
    for_each_value_of_alignment(*summary.alignment, Writer{json["alignment"]});
  json["convergence"] = Json::array();
  for (const output::ConvergenceEntry& entry : convergence)
    for_each_value_of_entry(entry, Writer{json["convergence"].emplace_back()});
  return json.dump();
}

void set_record(const std::string& text, output::Summary& summary, registration::Quality& quality,
                std::vector<output::ConvergenceEntry>& convergence) {
  try {
    const Json json = Json::parse(text);
    for_each_value(summary, Reader{json});
    json.at("at_bound").get_to(quality.at_bound);
    for_each_agreement(quality, [&](const char* name, auto& agreement) {
      if (json.contains("agreement") && json.at("agreement").contains(name))
        for_each_value_of_agreement(agreement.emplace(), Reader{json.at("agreement").at(name)});
    });
    if (json.contains("alignment"))
      for_each_value_of_alignment(summary.alignment.emplace(), Reader{json.at("alignment")});
    convergence.clear();
    summary.similarity.clear();
    for (const Json& value : json.at("convergence")) {
      output::ConvergenceEntry& entry = convergence.emplace_back();
      for_each_value_of_entry(entry, Reader{value});
      summary.similarity.push_back(
          {entry.stage, entry.level_mm, entry.iteration, entry.similarity});
    }
  } catch (const Json::exception&) {
    throw Error("The checkpoint holds no record of its run; run without --restart to begin from "
                "the start.");
  }
}

} // namespace prosup::pipeline
