#ifndef PROSUP_PIPELINE_COMMAND_TABLE_H
#define PROSUP_PIPELINE_COMMAND_TABLE_H

#include <deal.II/base/parameter_handler.h>
#include <mpi.h>

#include <functional>
#include <vector>

#include "command_options.h"
#include "prosup/pipeline/commands.h"

namespace prosup::pipeline {

/// What the command line holds, whatever the command.
struct Request {
  ParameterOptions parameters;
  MapRequest map;
  WarpRequest warp;
  FieldRequest field;
  ReportRequest report;
  LandmarkRequest landmarks;
  TableRequest table;
};

/// One command of the program: a new one is one more entry of all_commands().
struct Command {
  const char *name, *text;
  std::function<void(CLI::App&, const dealii::ParameterHandler& defaults, Request&)> add_options;
  std::function<Outcome(const Request&, MPI_Comm)> run;
};

std::vector<Command> all_commands();

/// Those of them that work with a finished registration.
std::vector<Command> result_commands();

} // namespace prosup::pipeline

#endif
