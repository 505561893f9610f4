#ifndef PROSUP_PIPELINE_COMMAND_OPTIONS_H
#define PROSUP_PIPELINE_COMMAND_OPTIONS_H

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <string>
#include <vector>

#include "prosup/core/parameters.h"

namespace CLI {
class App;
}

namespace prosup::pipeline {

/// What the command line of a command with a parameter file holds.
struct ParameterOptions {
  std::filesystem::path file;
  std::filesystem::path output = "results";
  bool overwrite = false;          ///< files that prosup did not write
  std::filesystem::path write_prm; ///< empty: run the command
  std::string log_level;           ///< of log_level_names()
  bool restart = false;            ///< go on from a checkpoint
  std::vector<Override> overrides; ///< of --set
  std::vector<Override> named;     ///< of options such as --chest; --set comes after them
};

/// Names of options that stand for one parameter each, such as "--chest".
using OptionNames = std::vector<std::string>;

/// All of them.
OptionNames all_parameter_options();

/// Adds the options --output, --overwrite, --log-level and --quiet to a command.
void add_output_option(CLI::App& command, ParameterOptions& options);

/// Adds FILE, --set, --write-prm and the options in `names` to a command. The values go to
/// `options`, which has to outlive the parsing; `defaults` holds all parameters as they are
/// declared, for the help.
void add_parameter_options(CLI::App& command, const OptionNames& names,
                           const dealii::ParameterHandler& defaults, ParameterOptions& options);

} // namespace prosup::pipeline

#endif
