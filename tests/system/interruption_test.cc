#include <fcntl.h>
#include <gtest/gtest.h>
#include <mpi.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "program.h"

extern char** environ;

namespace prosup::tests {
namespace {

namespace fs = std::filesystem;

/// `prosup register` of the small case, while it runs.
class RunningProgram {
public:
  RunningProgram(const TemporaryFolder& folder, const fs::path& output,
                 std::vector<std::string> launcher = {})
      : out_(folder / "out.txt"), err_(folder / "err.txt") {
    launcher.insert(launcher.end(), {PROSUP_PROGRAM, "register",
                                     PROSUP_PRM_FOLDER "/tests/small.prm", "--output", output});
    std::vector<char*> words;
    for (std::string& word : launcher)
      words.push_back(word.data());
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const auto& [descriptor, file] : {std::pair(1, out_.c_str()), std::pair(2, err_.c_str())})
      posix_spawn_file_actions_addopen(&actions, descriptor, file, O_WRONLY | O_CREAT | O_TRUNC,
                                       0600);
    // What ctest or a shell may have set to be ignored.
    posix_spawnattr_t attributes;
    sigset_t defaults;
    sigfillset(&defaults);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    EXPECT_EQ(posix_spawnp(&pid_, words[0], &actions, &attributes, words.data(), environ), 0);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
  }
  ~RunningProgram() {
    if (pid_ > 0)
      wait();
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Until it has come as far as to print `text`.
  void wait_for(const std::string& text) const {
    for (unsigned n = 0; n < 6000 && out().find(text) == std::string::npos; ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_NE(out().find(text), std::string::npos) << out() << err();
  }
  void send(int signal) const { kill(pid_, signal); }
  /// The exit code; that of a shell if it was ended by a signal.
  int wait() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  std::string out() const { return contents(out_); }
  std::string err() const { return contents(err_); }

private:
  const fs::path out_, err_;
  pid_t pid_ = 0;
};

std::size_t n_entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

std::size_t n_lines(const std::string& text) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find("prosup: ", at)) != std::string::npos; ++at)
    ++n;
  return n;
}

TEST(Interruption, BySignalLeavesNothingAndSaysSo) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "there");
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    RunningProgram run(folder, folder / "there/result");
    run.wait_for("Meshing");
    EXPECT_EQ(n_entries(folder / "there"), 1u);
    run.send(signal);
    EXPECT_EQ(run.wait(), 128 + signal);
    EXPECT_EQ(n_lines(run.err()), 1u) << run.err();
    EXPECT_NE(run.err().find("unfinished results were removed"), std::string::npos) << run.err();
    EXPECT_EQ(n_entries(folder / "there"), 0u);
  }
}

TEST(Interruption, KeepsTheEarlierResult) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_prosup({"mesh", PROSUP_PRM_FOLDER "/tests/small.prm", "--output", folder / "old"})
                .exit_code,
            0);
  const std::size_t n_files = n_entries(folder / "old");
  const std::string summary = contents(folder / "old/summary.json");
  RunningProgram run(folder, folder / "old");
  run.wait_for("Meshing");
  run.send(SIGTERM);
  EXPECT_EQ(run.wait(), 128 + SIGTERM);
  EXPECT_EQ(n_entries(folder / "old"), n_files);
  EXPECT_EQ(contents(folder / "old/summary.json"), summary);
}

TEST(Interruption, ByKillIsClearedAwayByTheNextRun) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "there");
  RunningProgram run(folder, folder / "there/result");
  run.wait_for("Meshing");
  run.send(SIGKILL);
  run.wait();
  EXPECT_FALSE(fs::exists(folder / "there/result"));
  EXPECT_EQ(n_entries(folder / "there"), 1u);
  const ProgramRun next = run_prosup(
      {"mesh", PROSUP_PRM_FOLDER "/tests/small.prm", "--output", folder / "there/result"});
  EXPECT_EQ(next.exit_code, 0) << next.transcript();
  EXPECT_EQ(n_entries(folder / "there"), 1u);
  EXPECT_TRUE(fs::exists(folder / "there/result/summary.json"));
}

// mpirun adds lines of its own. That of version 5 drops what ranks say after it was interrupted.
TEST(Interruption, UnderMpirunIsToldOnce) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "there");
  std::vector<std::string> launcher;
  std::istringstream words(PROSUP_MPIRUN " -np 2");
  for (std::string word; words >> word;)
    launcher.push_back(word);
  RunningProgram run(folder, folder / "there/result", launcher);
  run.wait_for("Meshing");
  run.send(SIGTERM);
  EXPECT_NE(run.wait(), 0);
#if OMPI_MAJOR_VERSION < 5
  EXPECT_EQ(n_lines(run.err()), 1u) << run.err();
#else
  EXPECT_LE(n_lines(run.err()), 1u) << run.err();
#endif
  EXPECT_EQ(n_entries(folder / "there"), 0u);
}

TEST(Interruption, ASecondRunIsRefusedAndTheFirstGoesOn) {
  const TemporaryFolder folder;
  RunningProgram first(folder, folder / "result");
  first.wait_for("Reading");
  const ProgramRun second =
      run_prosup({"mesh", PROSUP_PRM_FOLDER "/tests/small.prm", "--output", folder / "result"});
  EXPECT_EQ(second.exit_code, 1) << second.transcript();
  EXPECT_NE(second.err.find("Another run"), std::string::npos) << second.err;
  EXPECT_EQ(first.wait(), 0) << first.err();
  EXPECT_TRUE(fs::exists(folder / "result/convergence.csv"));
}

/// Runs a line of bash with $prosup, $prm and $output, and returns its exit code.
int run_bash(const TemporaryFolder& folder, const std::string& line) {
  const std::string script = "prosup=" + quoted(PROSUP_PROGRAM) +
                             " prm=" + quoted(PROSUP_PRM_FOLDER "/tests/small.prm") +
                             " output=" + quoted(folder / "result") + "; " + line;
  const std::string command = "bash -c " + quoted(script) + " > " + quoted(folder / "out.txt") +
                              " 2> " + quoted(folder / "err.txt");
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Interruption, ByAReaderThatGoesAway) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_bash(folder, "$prosup register $prm --output $output | head -1; "
                             "exit ${PIPESTATUS[0]}"),
            128 + SIGPIPE);
  const std::string err = contents(folder / "err.txt");
  EXPECT_EQ(n_lines(err), 1u) << err;
  EXPECT_EQ(n_entries(folder / ""), 2u); // what was printed
}

// No file may grow beyond a size, which stands for a full disk: in the meshes, in the fields.
TEST(Interruption, ByAFullDiskNamesTheFile) {
  for (const char* blocks : {"24", "400"}) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_bash(folder, std::string("ulimit -f ") + blocks +
                                   "; $prosup register $prm --output $output"),
              1);
    const std::string err = contents(folder / "err.txt");
    EXPECT_EQ(n_lines(err), 1u) << err;
    EXPECT_NE(err.find("cannot be written"), std::string::npos) << err;
    EXPECT_NE(err.find((folder / "result/").string()), std::string::npos)
        << err; // not a temporary name
    EXPECT_EQ(n_entries(folder / ""), 2u);
  }
}

// Runs without mpirun share Open MPI's folder of temporary files, and the first that ends removes
// it.
TEST(Environment, WithoutItsTemporaryFilesOpenMpiIsQuiet) {
  const TemporaryFolder folder;
  const fs::path temporary = folder / "temporary";
  fs::create_directory(temporary);
  RunningProgram run(folder, folder / "result", {"env", "TMPDIR=" + temporary.string()});
  run.wait_for("Meshing");
  for (const auto& entry : fs::directory_iterator(temporary))
    fs::remove_all(entry);
  EXPECT_EQ(run.wait(), 0);
  EXPECT_EQ(run.err(), "");
}

TEST(Environment, WithNonsenseIsNoReasonToCrash) {
  for (const char* variable : {"DEAL_II_NUM_THREADS", "OMP_NUM_THREADS"})
    for (const char* value : {"abc", "-3", "0", "99999999999999999999", ""}) {
      const TemporaryFolder folder;
      EXPECT_EQ(run_bash(folder, std::string(variable) + "=" + value + " $prosup --version"), 0);
      const std::string err = contents(folder / "err.txt");
      EXPECT_EQ(n_lines(err), 1u) << err;
      EXPECT_NE(err.find(variable), std::string::npos) << err;
    }
  const TemporaryFolder folder;
  EXPECT_EQ(run_bash(folder, "DEAL_II_NUM_THREADS=2 OMP_NUM_THREADS=4,2 $prosup --version"), 0);
  EXPECT_EQ(contents(folder / "err.txt"), "");
}

// Closed streams: what is printed must not go into a result.
TEST(Environment, WithClosedStreams) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_bash(folder, "$prosup mesh $prm --output $output <&- >&- 2>&-"), 0);
  EXPECT_TRUE(fs::exists(folder / "result/summary.json"));
  for (const auto& entry : fs::directory_iterator(folder / "result"))
    EXPECT_EQ(contents(entry.path()).find("Results are in"), std::string::npos) << entry.path();
}

TEST(Environment, WithLittleMemoryIsToldInOneLine) {
  const TemporaryFolder folder;
  if (run_bash(folder, "ulimit -v 700000; $prosup register $prm --output $output") == 0)
    GTEST_SKIP() << "it is enough here";
  EXPECT_NE(contents(folder / "err.txt").find("memory"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "result"));
}

} // namespace
} // namespace prosup::tests
