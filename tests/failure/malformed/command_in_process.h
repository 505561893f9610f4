#ifndef PROSUP_TESTS_COMMAND_IN_PROCESS_H
#define PROSUP_TESTS_COMMAND_IN_PROCESS_H

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

#include "prosup/pipeline/command_line.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {

/// Sends a file descriptor of this process to a file for the time of its life.
class Redirection {
public:
  Redirection(int descriptor, const std::string& file)
      : descriptor_(descriptor), before_(dup(descriptor)) {
    std::fflush(nullptr);
    const int to = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(to, descriptor_);
    close(to);
  }
  ~Redirection() {
    std::fflush(nullptr);
    dup2(before_, descriptor_);
    close(before_);
  }
  Redirection(const Redirection&) = delete;
  Redirection& operator=(const Redirection&) = delete;

private:
  int descriptor_, before_;
};

struct CommandResult {
  int exit_code;
  std::string err; ///< without warnings
};

/// Runs a command line of prosup in this process, which saves the time to start one; `folder` is
/// for what it prints.
inline CommandResult run_in_process(std::vector<std::string> arguments,
                                    const TemporaryFolder& folder) {
  arguments.insert(arguments.begin(), "prosup");
  std::vector<char*> argv;
  for (std::string& argument : arguments)
    argv.push_back(argument.data());
  argv.push_back(nullptr);
  CommandResult result{};
  {
    const Redirection out(STDOUT_FILENO, folder / "out"), err(STDERR_FILENO, folder / "err");
    result.exit_code =
        pipeline::run_command_line(int(arguments.size()), argv.data(), MPI_COMM_WORLD);
  }
  result.err = without_warnings(contents(folder / "err"));
  return result;
}

} // namespace prosup::tests

#endif
