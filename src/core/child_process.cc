#include "prosup/core/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <sstream>

#include "prosup/core/error.h"

namespace prosup {

namespace fs = std::filesystem;

namespace {

/// The environment of this process as it was when it started.
std::vector<std::string> first_environment() {
  std::ifstream file("/proc/self/environ");
  std::vector<std::string> variables;
  for (std::string variable; std::getline(file, variable, '\0');)
    variables.push_back(variable);
  return variables;
}

/// Pointers to words, as the system calls take them.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  for (std::string& word : words)
    result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

std::string name_of(const std::string& variable) {
  return variable.substr(0, variable.find('='));
}

/// Where input and output of a child go.
class Redirection {
public:
  explicit Redirection(const fs::path& log)
      : out_(log.string() + ".out"), err_(log.string() + ".err") {
    constexpr int to_file = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, out_.c_str(), to_file, 0644);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, err_.c_str(), to_file, 0644);
  }
  ~Redirection() { posix_spawn_file_actions_destroy(&actions_); }
  Redirection(const Redirection&) = delete;
  Redirection& operator=(const Redirection&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }

private:
  const std::string out_, err_;
  posix_spawn_file_actions_t actions_{};
};

pid_t start(Command command, const fs::path& log, const std::vector<std::string>& variables) {
  std::vector<std::string> environment = first_environment();
  for (const std::string& variable : variables) {
    const std::string name = name_of(variable);
    environment.erase(
        std::remove_if(environment.begin(), environment.end(),
                       [&](const std::string& other) { return name_of(other) == name; }),
        environment.end());
    environment.push_back(variable);
  }
  const Redirection redirection(log);
  const std::string program = command.front();
  pid_t pid = 0;
  const int failure = posix_spawnp(&pid, program.c_str(), redirection.actions(), nullptr,
                                   pointers(command).data(), pointers(environment).data());
  if (failure != 0)
    throw Error("The program '" + program + "' cannot be started: " + std::strerror(failure) +
                "; check that it is installed and that '" + log.parent_path().string() +
                "' may be written to.");
  return pid;
}

} // namespace

ChildResult run_child(const Command& command, const fs::path& log,
                      const std::vector<std::string>& variables) {
  const auto begin = std::chrono::steady_clock::now();
  const pid_t pid = start(command, log, variables);
  int status = 0;
  rusage usage{};
  while (wait4(pid, &status, 0, &usage) < 0)
    if (errno != EINTR)
      throw Error("The program '" + command.front() +
                  "' was started and lost: " + std::strerror(errno) + ".");
  const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
  ChildResult result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.wall_seconds = duration.count();
  result.peak_memory = static_cast<double>(usage.ru_maxrss) / 1024.;
  return result;
}

fs::path find_program(const std::string& name) {
  std::istringstream folders(started_with("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path file = fs::path(folder) / name;
        access(file.c_str(), X_OK) == 0 && fs::is_regular_file(file))
      return file;
  return {};
}

fs::path this_program() {
  return fs::read_symlink("/proc/self/exe");
}

std::string started_with(const std::string& variable) {
  for (const std::string& entry : first_environment())
    if (name_of(entry) == variable)
      return entry.substr(variable.size() + 1);
  return {};
}

} // namespace prosup
