#include "command_app.h"

#include "prosup/core/version.h"

namespace prosup::pipeline {

namespace {

/// All parameters with their defaults.
void declare_defaults(dealii::ParameterHandler& defaults) {
  const AllParameters parameters;
  dealii::ParameterAcceptor::declare_all_parameters(defaults);
}

/// What --help says of the exit code.
constexpr const char* exit_codes =
    "Exit codes: 0 success; 1 wrong input, or no memory or space on the disk: nothing was written; "
    "2 results were written, but a simulation did not settle (unload, load); 3 results were "
    "written, "
    "but the verdict on the registration is that it failed (register); 128 + N ended by signal N: "
    "nothing was written. One line on standard error says why.";

} // namespace

CommandApp::CommandApp()
    : app("Aligns a prone and a supine breast image by finite elements.", "prosup"),
      commands(all_commands()) {
  app.set_version_flag("--version", version());
  app.require_subcommand(1);
  app.footer(exit_codes);
  dealii::ParameterHandler defaults;
  declare_defaults(defaults);
  for (const Command& command : commands) {
    CLI::App& subcommand = *app.add_subcommand(command.name, command.text);
    command.add_options(subcommand, defaults, request);
    subcommand.set_version_flag("--version", version());
    subcommand.footer(exit_codes);
  }
}

} // namespace prosup::pipeline
