#ifndef PROSUP_SRC_PIPELINE_COMMAND_APP_H
#define PROSUP_SRC_PIPELINE_COMMAND_APP_H

#include <CLI/CLI.hpp>
#include <vector>

#include "command_table.h"

namespace prosup::pipeline {

/// All commands with their options, as run_command_line() reads them and as the manual pages and
/// the completion tell them.
class CommandApp {
public:
  CommandApp();

  CLI::App app;
  Request request; ///< what app.parse() has read
  std::vector<Command> commands;
};

} // namespace prosup::pipeline

#endif
