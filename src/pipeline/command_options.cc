#include "command_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "prosup/core/file_system.h"
#include "prosup/core/log_level.h"
#include "prosup/core/text.h"
#include "prosup/prepare/breast_region.h"
#include "prosup/prepare/contrast.h"
#include "prosup/registration/breast_model.h"
#include "prosup/similarity/similarity_parameters.h"
#include "prosup/unloading/support_parameters.h"

namespace prosup::pipeline {

namespace {

/// An option that stands for one parameter.
struct ParameterOption {
  std::string name, section, entry, text;
  bool is_file = false;
};

const std::vector<ParameterOption>& parameter_options() {
  static const std::vector<ParameterOption> options{
      {"--prone-image", "Case", "Prone image", "Image of the prone breast", true},
      {"--prone-labels", "Case", "Prone labels", "Labels of the prone image", true},
      {"--supine-image", "Case", "Supine image", "Image of the supine breast", true},
      {"--supine-labels", "Case", "Supine labels", "Labels of the supine image", true},
      {"--landmarks", "Case", "Landmarks", "Landmarks for the evaluation, CSV", true},
      {"--prone-gravity", "Case", "Prone gravity", "Direction of gravity, x,y,z (LPS)"},
      {"--supine-gravity", "Case", "Supine gravity", "Direction of gravity, x,y,z (LPS)"},
      {"--chest", "Case", "Chest",
       "Motion on the chest wall: " + joined(unloading::chest_condition_names())},
      {"--prone", "Scans", "Prone", "Prone scan: a file, or a folder of DICOM files", true},
      {"--supine", "Scans", "Supine", "Supine scan: a file, or a folder of DICOM files", true},
      {"--prone-chest", "Scans", "Prone chest",
       "Mask of the prone chest, instead of a search of the chest wall", true},
      {"--prone-breast", "Scans", "Prone breast",
       "Mask of the prone breast, which limits its tissue", true},
      {"--prone-gland", "Scans", "Prone gland",
       "Mask of the prone gland, instead of a classification", true},
      {"--supine-chest", "Scans", "Supine chest",
       "Mask of the supine chest, instead of a search of the chest wall", true},
      {"--supine-breast", "Scans", "Supine breast",
       "Mask of the supine breast, which limits its tissue", true},
      {"--supine-gland", "Scans", "Supine gland",
       "Mask of the supine gland, instead of a classification", true},
      {"--series", "Scans", "Series",
       "Number of the series in a DICOM folder, or two: prone,supine"},
      {"--side", "Preparation", "Side", "Breast to prepare: " + joined(prepare::side_names())},
      {"--contrast", "Preparation", "Contrast",
       "What the scans show: automatic, " + joined(prepare::contrast_names())},
      {"--state", "Case", "State", "Which breast to work on: prone or supine"},
      {"--method", "Simulation", "Method",
       "Numerical method: " + joined(registration::method_names())},
      {"--similarity", "Similarity", "Metric",
       "Measure of similarity: automatic, " + joined(similarity::metric_names())},
  };
  return options;
}

const ParameterOption& find(const std::string& name) {
  const auto& options = parameter_options();
  return *std::find_if(options.begin(), options.end(),
                       [&](const ParameterOption& option) { return option.name == name; });
}

} // namespace

OptionNames all_parameter_options() {
  OptionNames names;
  for (const ParameterOption& option : parameter_options())
    names.push_back(option.name);
  return names;
}

void add_output_option(CLI::App& command, ParameterOptions& options) {
  command.add_option("--output", options.output, "Folder for the results")->capture_default_str();
  command.add_flag("--overwrite", options.overwrite,
                   "Replace also files that prosup did not write or that changed since");
  options.log_level = "info";
  CLI::Option* const level =
      command
          .add_option("--log-level", options.log_level,
                      "What is shown: " + joined(log_level_names()) +
                          ". Each shows more than the one before; log.txt in the results holds "
                          "all of info at least")
          ->check(CLI::IsMember(log_level_names()))
          ->capture_default_str();
  command
      .add_flag_callback(
          "--quiet", [&options] { options.log_level = "warning"; },
          "The same as --log-level warning")
      ->excludes(level);
}

void add_parameter_options(CLI::App& command, const OptionNames& names,
                           const dealii::ParameterHandler& defaults, ParameterOptions& options) {
  command.add_option("FILE", options.file, "Parameter file (.prm)");
  command.add_option("--set", options.overrides,
                     "Set a parameter, \"Section/Entry=value\"; may be repeated");
  command.add_option(
      "--write-prm", options.write_prm,
      "Write all parameters, with units and documentation, to a file (.prm, or .md for a "
      "table) and stop");
  for (const std::string& name : names) {
    const ParameterOption& option = find(name);
    command
        .add_option_function<std::string>(
            option.name,
            [&options, &option](const std::string& value) {
              options.named.push_back(option.section + "/" + option.entry + "=" +
                                      (option.is_file ? absolute_path(value).string() : value));
            },
            option.text)
        ->default_str(defaults.get({option.section}, option.entry));
  }
}

} // namespace prosup::pipeline
