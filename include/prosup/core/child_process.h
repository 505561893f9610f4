#ifndef PROSUP_CORE_CHILD_PROCESS_H
#define PROSUP_CORE_CHILD_PROCESS_H

#include <filesystem>
#include <string>
#include <vector>

namespace prosup {

/// A program and its arguments. They are passed on unchanged; no shell interprets them.
using Command = std::vector<std::string>;

/// Result of a program that has ended.
struct ChildResult {
  int exit_code = 0;        ///< 128 + number of the signal that ended it
  double wall_seconds = 0.; ///< of the whole process, to 0.01 s
  double peak_memory = 0.;  ///< of all its processes together, sampled every 0.01 s, MiB
};

/// Runs a program and waits for its end. Standard output and standard error go to the files
/// `<log>.out` and `<log>.err`; standard input is empty. The program gets the environment with
/// which this process was started, without what MPI has added since, and then `variables`
/// ("NAME=value").
/// @throws Error if the program cannot be started.
ChildResult run_child(const Command& command, const std::filesystem::path& log,
                      const std::vector<std::string>& variables = {});

/// Path of a program on the search path; empty if it is not found.
std::filesystem::path find_program(const std::string& name);

/// Path of the executable of this process.
std::filesystem::path this_program();

/// Value of an environment variable at the start of this process; empty if it was not set.
std::string started_with(const std::string& variable);

} // namespace prosup

#endif
