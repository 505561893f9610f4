#include "prosup/pipeline/command_line.h"

#include <CLI/CLI.hpp>
#include <deal.II/base/mpi.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "prosup/core/collective.h"
#include "prosup/core/parameters.h"
#include "prosup/core/text.h"
#include "prosup/core/version.h"
#include "prosup/pipeline/commands.h"
#include "prosup/similarity/similarity_parameters.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

namespace {

constexpr int success = 0, failure = 1, not_settled = 2;

/// A command that takes a parameter file.
struct Command {
  const char *name, *text;
  bool (*run)(const AllParameters&, const dealii::ParameterHandler&, const fs::path&, MPI_Comm);
};

constexpr Command commands_with_parameters[] = {
    {"register", "Both images and masks to the registered unloaded pair", run_register},
    {"unload", "One mask (and image) to its unloaded configuration", run_unload},
    {"load", "One unloaded mask (and image) or mesh to its loaded configuration", run_load},
    {"mesh", "One mask to a mesh, with a quality report", run_mesh},
    {"phantom", "Images of a numerical phantom, with their truth", run_phantom},
    {"compare", "Runs of prosup and of other programs: speed against error", run_compare}};

/// What stands on the command line of the commands that take a parameter file.
struct Options {
  fs::path file;
  fs::path output = "results";
  fs::path write_prm;
  std::vector<Override> overrides; ///< --set
  std::vector<Override> inputs;    ///< --prone-image and the like
};

std::string absolute_path(const std::string& file) {
  return fs::absolute(file).lexically_normal().string();
}

/// Options that stand for an entry of section Case.
void add_case_options(CLI::App& command, Options& options) {
  struct CaseOption {
    const char *option, *entry, *text;
    bool is_file;
  };
  static const CaseOption case_options[] = {
      {"--prone-image", "Prone image", "Image of the prone breast", true},
      {"--prone-labels", "Prone labels", "Labels of the prone image", true},
      {"--supine-image", "Supine image", "Image of the supine breast", true},
      {"--supine-labels", "Supine labels", "Labels of the supine image", true},
      {"--landmarks", "Landmarks", "Landmarks for the evaluation, CSV", true},
      {"--prone-gravity", "Prone gravity", "Direction of gravity, x,y,z (LPS)", false},
      {"--supine-gravity", "Supine gravity", "Direction of gravity, x,y,z (LPS)", false},
      {"--chest", "Chest", "Motion on the chest wall: fixed, sliding or one-sided", false},

      {"--state", "State", "What mesh, unload and load work on: prone or supine", false},
  };
  for (const CaseOption& c : case_options)
    command.add_option_function<std::string>(
        c.option,
        [&options, c](const std::string& value) {
          options.inputs.push_back("Case/" + std::string(c.entry) + "=" +
                                   (c.is_file ? absolute_path(value) : value));
        },
        c.text);
  command.add_option_function<std::string>(
      "--method",
      [&options](const std::string& value) {
        options.inputs.push_back("Simulation/Method=" + value);
      },
      "Numerical method: " + joined(registration::method_names()));
  command.add_option_function<std::string>(
      "--similarity",
      [&options](const std::string& value) {
        options.inputs.push_back("Similarity/Metric=" + value);
      },
      "Measure of similarity: " + joined(similarity::metric_names()));
}

void add_common_options(CLI::App& command, Options& options) {
  command.add_option("FILE", options.file, "Parameter file (.prm)");
  command.add_option("--output", options.output, "Folder for the results")->capture_default_str();
  command.add_option("--set", options.overrides,
                     "Override \"Section/Entry=value\"; may be repeated");
  command.add_option("--write-prm", options.write_prm,
                     "Write all parameters, with units and documentation, to a file and stop");
  add_case_options(command, options);
  command.set_version_flag("--version", version());
}

/// Gives the parameters their values. True if there is work to do.
bool prepare(const Options& options, AllParameters& parameters, dealii::ParameterHandler& handler,
             MPI_Comm world) {
  std::vector<Override> overrides = options.inputs;
  overrides.insert(overrides.end(), options.overrides.begin(), options.overrides.end());
  on_every_rank(world, [&] {
    read_parameters(handler, options.file, overrides);
    const fs::path folder =
        options.file.empty() ? fs::current_path() : fs::absolute(options.file).parent_path();
    parameters.case_files.resolve(folder, handler);
    parameters.single_state.resolve(folder, handler);
    parameters.comparison.resolve(folder, handler);
  });
  if (options.write_prm.empty())
    return true;
  on_root(world, [&] { write_parameters(handler, options.write_prm); });
  return false;
}

int run_with_parameters(const std::string& command, const Options& options, MPI_Comm world) {
  AllParameters parameters;
  dealii::ParameterHandler handler;
  if (!prepare(options, parameters, handler, world))
    return success;
  for (const Command& entry : commands_with_parameters)
    if (command == entry.name)
      return entry.run(parameters, handler, options.output, world) ? success : not_settled;
  return failure;
}

void add_map_options(CLI::App& command, MapRequest& request) {
  const CLI::IsMember states({"prone", "supine", "unloaded"});
  command.add_option("--result", request.result, "Result folder of prosup register")->required();
  command.add_option("--from", request.from, "State of the points")->required()->check(states);
  command.add_option("--to", request.to, "State to map them to")->required()->check(states);
  command
      .add_option("POINTS", request.points, "Points: CSV (id,x,y,z), .fcsv or .mrk.json; LPS mm")
      ->required();
  command.add_option("-o,--output", request.output, "CSV file to write")->required();
  command.set_version_flag("--version", version());
}

void add_landmark_options(CLI::App& command, LandmarkRequest& request) {
  command.add_option("--result", request.result, "Result folder of prosup register")->required();
  command.add_option("OBSERVERS", request.observers, "Landmarks of one observer each, CSV")
      ->required();
  command.add_option("--control", request.control,
                     "Supine landmarks of an observer who was shown the prone ones of the first: "
                     "CSV (id,supine_x,... or id,x,y,z), .fcsv or .mrk.json");
  command
      .add_option("--exclude-above", request.exclude_above,
                  "Landmarks that two observers place further apart are not reliable (mm)")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command.add_option("-o,--output", request.output, "CSV file to write")->required();
  command.set_version_flag("--version", version());
}

int report(const std::string& message, MPI_Comm world) {
  if (dealii::Utilities::MPI::this_mpi_process(world) == 0)
    std::fprintf(stderr, "prosup: %s\n", message.c_str());
  return failure;
}

/// The sentence for a command line without a command that exists.
std::string no_command(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining();
  std::string commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    commands += (commands.empty() ? "" : ", ") + command->get_name();
  return (words.empty() ? "No command is given" : "'" + words.front() + "' is no command") +
         "; the commands are " + commands + " (see prosup --help).";
}

/// Help and version are printed by one rank only.
int answer(const CLI::App& app, const CLI::ParseError& request, MPI_Comm world) {
  if (dealii::Utilities::MPI::this_mpi_process(world) != 0)
    return request.get_exit_code() == 0 ? success : failure;
  if (request.get_exit_code() == 0)
    return app.exit(request);
  if (app.get_subcommands().empty())
    return report(no_command(app), world);
  return report(std::string(request.what()) + " (see prosup --help).", world);
}

} // namespace

int run_command_line(int argc, char** argv, MPI_Comm world) {
  CLI::App app{"Aligns a prone and a supine breast image by finite elements.", "prosup"};
  app.set_version_flag("--version", version());
  app.require_subcommand(1);
  Options options;
  MapRequest map;
  LandmarkRequest landmarks;
  for (const Command& command : commands_with_parameters)
    add_common_options(*app.add_subcommand(command.name, command.text), options);
  add_map_options(*app.add_subcommand("map", "Points from one state to another"), map);
  add_landmark_options(
      *app.add_subcommand("landmarks", "Errors at the landmarks of several observers"), landmarks);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& request) {
    return answer(app, request, world);
  }
  try {
    const std::string command = app.get_subcommands().front()->get_name();
    if (command == "map")
      on_root(world, [&] { run_map(map); });
    else if (command == "landmarks")
      on_root(world, [&] { run_landmarks(landmarks); });
    else
      return run_with_parameters(command, options, world);
    return success;
  } catch (const std::exception& error) {
    return report(error.what(), world);
  }
}

} // namespace prosup::pipeline
