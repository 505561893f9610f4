#include "command_table.h"

#include <CLI/CLI.hpp>
#include <initializer_list>

#include "prosup/core/collective.h"
#include "prosup/core/file_system.h"
#include "prosup/core/log_level.h"
#include "prosup/core/output_file.h"
#include "prosup/core/parameters.h"
#include "prosup/core/text.h"
#include "run_files.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

namespace {

/// Gives the parameters their values. True if there is work to do.
bool prepare(const ParameterOptions& options, AllParameters& parameters,
             dealii::ParameterHandler& handler, MPI_Comm world) {
  std::vector<Override> overrides = options.named;
  overrides.insert(overrides.end(), options.overrides.begin(), options.overrides.end());
  on_every_rank(world, [&] {
    read_parameters(handler, options.file, overrides);
    const fs::path folder =
        options.file.empty() ? absolute_path(".") : absolute_path(options.file).parent_path();
    parameters.case_files.resolve(folder, handler);
    parameters.single_state.resolve(folder, handler);
    parameters.comparison.resolve(folder, handler);
    parameters.scans.resolve(folder, handler);
  });
  if (options.write_prm.empty())
    return true;
  on_root(world, [&] {
    OutputFile file(options.write_prm,
                    {files_read(parameters, options.file), options.overwrite, ""});
    if (lower_case(options.write_prm.extension().string()) == ".md")
      write_parameter_reference(handler, file.path());
    else
      write_parameters(handler, file.path());
    file.commit();
  });
  return false;
}

/// `run` is a command of commands.h with a parameter file.
template <typename Run>
Outcome run_with_parameters(Run run, const ParameterOptions& options, MPI_Comm world) {
  if (!options.log_level.empty())
    set_log_level(enumerator<LogLevel>(options.log_level, log_level_names()));
  AllParameters parameters;
  parameters.checkpoint.restart = options.restart;
  dealii::ParameterHandler handler;
  if (!prepare(options, parameters, handler, world))
    return Outcome::success;
  const ResultTarget target{options.output, options.overwrite,
                            files_read(parameters, options.file)};
  return outcome_of(run(parameters, handler, target, world));
}

/// What a command with a parameter file has options for.
struct Abilities {
  bool writes_results = true, can_restart = false;
};

/// A command with a parameter file, and the options that it takes besides the common ones.
template <typename Run>
Command with_parameters(const char* name, const char* text, const OptionNames& options, Run run,
                        Abilities abilities = {}) {
  return {name, text,
          [=](CLI::App& app, const dealii::ParameterHandler& defaults, Request& request) {
            add_parameter_options(app, options, defaults, request.parameters);
            if (abilities.writes_results)
              add_output_option(app, request.parameters);
            if (abilities.can_restart)
              app.add_flag("--restart", request.parameters.restart,
                           "Go on from the last checkpoint of a run that was ended");
          },
          [run](const Request& request, MPI_Comm world) {
            return run_with_parameters(run, request.parameters, world);
          }};
}

} // namespace

std::vector<Command> all_commands() {
  const OptionNames labels{"--prone-labels", "--supine-labels"};
  const OptionNames images{"--prone-image", "--supine-image"};
  const OptionNames gravity{"--prone-gravity", "--supine-gravity"};
  const OptionNames simulation{"--chest", "--method"};
  const OptionNames scans{"--prone",        "--supine",        "--series",       "--side",
                          "--contrast",     "--prone-chest",   "--prone-breast", "--prone-gland",
                          "--supine-chest", "--supine-breast", "--supine-gland"};
  const auto all_of = [](std::initializer_list<OptionNames> lists) {
    OptionNames names;
    for (const OptionNames& list : lists)
      names.insert(names.end(), list.begin(), list.end());
    return names;
  };
  const OptionNames one_breast = all_of({images, labels, {"--state"}, gravity, simulation});
  std::vector<Command> commands{
      with_parameters(
          "register", "Both images and masks, or scans, to the registered unloaded pair",
          all_of({images, labels, scans, {"--landmarks"}, gravity, simulation, {"--similarity"}}),
          run_register, {true, true}),
      with_parameters(
          "check", "What is wrong with the input of register, in seconds",
          all_of({images, labels, {"--landmarks"}, gravity, simulation, {"--similarity"}}),
          run_check, {false, false}),
      with_parameters("unload", "One mask (and image) to its unloaded configuration",
                      all_of({one_breast, {"--landmarks"}}), run_unload, {true, true}),
      with_parameters("load", "One unloaded mask (and image) or mesh to its loaded configuration",
                      one_breast, run_load, {true, true}),
      with_parameters("prepare", "Scans to images and labels that register takes", scans,
                      run_prepare),
      with_parameters("mesh", "One mask to a mesh, with a quality report",
                      all_of({labels, {"--state"}}), run_mesh),
      with_parameters("phantom", "Images of a numerical phantom, with their truth", gravity,
                      run_phantom),
      with_parameters("compare", "Runs of prosup and of other programs: speed against error",
                      all_parameter_options(), run_compare)};
  for (Command& command : result_commands())
    commands.push_back(std::move(command));
  return commands;
}

} // namespace prosup::pipeline
