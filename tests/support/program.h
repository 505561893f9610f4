#ifndef PROSUP_TESTS_PROGRAM_H
#define PROSUP_TESTS_PROGRAM_H

#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {

/// What a run of the prosup program left behind.
struct ProgramRun {
  int exit_code = -1; ///< -1 if it was ended by a signal
  std::string out, err;

  /// All of it, for messages of failed checks.
  std::string transcript() const {
    return "exit code " + std::to_string(exit_code) + "\n--- out\n" + out + "--- err\n" + err;
  }
};

inline std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word)
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// Runs prosup with `arguments`, on its own or under mpirun with several ranks.
inline ProgramRun run_prosup(const std::vector<std::string>& arguments, unsigned n_ranks = 1) {
  const TemporaryFolder folder;
  std::string command;
  if (n_ranks > 1)
    command = std::string(PROSUP_MPIRUN) + " -np " + std::to_string(n_ranks) + " ";
  command += quoted(PROSUP_PROGRAM);
  for (const std::string& argument : arguments)
    command += " " + quoted(argument);
  command += " > " + quoted(folder / "out") + " 2> " + quoted(folder / "err") + " < /dev/null";
  const int status = std::system(command.c_str());
  ProgramRun run;
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.out = contents(folder / "out");
  run.err = contents(folder / "err");
  return run;
}

/// A file of the test data.
inline std::string data_file(const std::string& name) {
  return std::string(PROSUP_TEST_DATA) + "/" + name;
}

} // namespace prosup::tests

#endif
