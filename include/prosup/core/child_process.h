#ifndef PROSUP_CORE_CHILD_PROCESS_H
#define PROSUP_CORE_CHILD_PROCESS_H

#include <filesystem>
#include <string>
#include <vector>

namespace prosup {

/// A program and its arguments, as they are: no shell reads them.
using Command = std::vector<std::string>;

/// What a program that has ended left behind.
struct ChildResult {
  int exit_code = 0;        ///< 128 + number of the signal that ended it
  double wall_seconds = 0.; ///< of the whole process, to 0.01 s
  double peak_memory = 0.;  ///< of all its processes together, sampled every 0.01 s, MiB
};

/// Runs a program to its end. Its standard output and error go to the files
/// `<log>.out` and `<log>.err`, its input is empty. It gets the environment with which
/// this process was started, so that nothing of a running MPI is handed on, and
/// `variables` ("NAME=value") on top of it.
/// @throws Error if the program cannot be started.
ChildResult run_child(const Command& command, const std::filesystem::path& log,
                      const std::vector<std::string>& variables = {});

/// Where a program of this name lies on the search path; empty if nowhere.
std::filesystem::path find_program(const std::string& name);

/// The file that this process runs.
std::filesystem::path this_program();

/// Value of a variable of the environment with which this process was started;
/// empty if it is not set.
std::string started_with(const std::string& variable);

} // namespace prosup

#endif
