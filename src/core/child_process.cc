#include "prosup/core/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

#include "prosup/core/error.h"
#include "prosup/core/unfinished.h"

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

/// Most memory that a process has used so far, MiB.
double high_water_mark(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/status");
  const std::string name = "VmHWM:";
  for (std::string line; std::getline(file, line);)
    if (line.compare(0, name.size(), name) == 0)
      return std::strtod(line.c_str() + name.size(), nullptr) / 1024.;
  return 0.;
}

/// The same of a process and all that it has started, MiB.
double memory_of_tree(pid_t pid) {
  double sum = high_water_mark(pid);
  const std::string number = std::to_string(pid);
  std::ifstream children("/proc/" + number + "/task/" + number + "/children");
  for (pid_t child = 0; children >> child;)
    sum += memory_of_tree(child);
  return sum;
}

} // namespace

ChildResult run_child(const Command& command, const fs::path& log,
                      const std::vector<std::string>& variables) {
  const auto begin = std::chrono::steady_clock::now();
  const pid_t pid = start(command, log, variables);
  const Unfinished running([pid] { kill(pid, SIGTERM); });
  ChildResult result;
  int status = 0;
  // The figure of wait4() would be at least that of this process.
  for (pid_t ended = 0; ended == 0; ended = waitpid(pid, &status, WNOHANG)) {
    result.peak_memory = std::max(result.peak_memory, memory_of_tree(pid));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.wall_seconds = duration.count();
  return result;
}

fs::path find_program(const std::string& name) {
  std::istringstream folders(started_with("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');)
    if (fs::path file = fs::path(folder) / name;
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
