#include "prosup/pipeline/command_line.h"

#include <deal.II/base/mpi.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "command_app.h"
#include "prosup/core/error.h"
#include "prosup/core/exception_text.h"
#include "prosup/core/unfinished.h"

namespace prosup::pipeline {

namespace {

constexpr int success = static_cast<int>(Outcome::success), failure = 1;

int report(const std::string& message, MPI_Comm world) {
  // After a signal the error is that files are gone, and this waits for the end of the program.
  const auto lock = uninterrupted();
  if (dealii::Utilities::MPI::this_mpi_process(world) == 0)
    std::fprintf(stderr, "prosup: %s\n", message.c_str());
  return failure;
}

/// For exceptions that, unlike an Error, may have come on this rank only: the others would wait for
/// it. They have a moment to come to the same end, so that rank 0 tells it if it can.
int report_and_end_all(const std::exception& exception, MPI_Comm world) {
  if (dealii::Utilities::MPI::n_mpi_processes(world) == 1)
    return report(text_of(exception), world);
  if (dealii::Utilities::MPI::this_mpi_process(world) > 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  abandon_unfinished();
  std::fprintf(stderr, "prosup: %s\n", text_of(exception).c_str());
  MPI_Abort(world, failure);
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

/// The sentence for what a command does not understand.
std::string not_understood(const CLI::App& command, const CLI::ParseError& error) {
  const std::string help = "prosup " + command.get_name() + " --help";
  for (const std::string& word : command.remaining())
    if (word.rfind("-", 0) == 0)
      return "'" + command.get_name() + "' takes no option '" + word + "'; " + help +
             " lists those that it takes.";
  return std::string(error.what()) + " (see " + help + ").";
}

/// Help and version are printed by one rank only.
int answer(const CLI::App& app, const CLI::ParseError& request, MPI_Comm world) {
  if (dealii::Utilities::MPI::this_mpi_process(world) != 0)
    return request.get_exit_code() == 0 ? success : failure;
  if (request.get_exit_code() == 0)
    return app.exit(request);
  if (app.get_subcommands().empty())
    return report(no_command(app), world);
  return report(not_understood(*app.get_subcommands().front(), request), world);
}

} // namespace

int run_command_line(int argc, char** argv, MPI_Comm world) {
  CommandApp all;
  try {
    all.app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return answer(all.app, error, world);
  } catch (const std::exception& error) { // the same on all ranks
    return report(text_of(error), world);
  }
  try {
    for (const Command& command : all.commands)
      if (all.app.got_subcommand(command.name))
        return static_cast<int>(command.run(all.request, world));
    return failure;
  } catch (const Error& error) {
    return report(text_of(error), world);
  } catch (const std::exception& error) {
    return report_and_end_all(error, world);
  }
}

} // namespace prosup::pipeline
