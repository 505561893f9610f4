#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>

#include "prosup/core/position.h"
#include "prosup/output/vtu.h"
#include "small_registration.h"

namespace prosup::tests {
namespace {

namespace fs = std::filesystem;

/// A registration that keeps itself wherever it can, and is ended on the way.
class Restart : public ::testing::Test {
protected:
  std::vector<std::string> arguments(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"register", PROSUP_PRM_FOLDER "/tests/small.prm",
                                 "--output", output(),
                                 "--set",    "Checkpoint/Interval=0"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  std::string output() const { return folder_ / "out"; }
  fs::path checkpoint(const std::string& name) const {
    return folder_ / ("out.checkpoint/" + name);
  }

  /// Starts the registration and kills it once it has said `word`.
  void run_until(const std::string& word) const {
    run_until(arguments(),
              [&] { return contents(folder_ / "log").find(word) != std::string::npos; });
  }

  /// Starts a run and ends it once it is `far_enough`.
  void run_until(std::vector<std::string> words, const std::function<bool()>& far_enough,
                 int signal = SIGKILL) const {
    const std::string log = folder_ / "log";
    text_file(log, "");
    const pid_t child = fork();
    if (child == 0) {
      std::vector<char*> argv{const_cast<char*>(PROSUP_PROGRAM)};
      for (std::string& argument : words)
        argv.push_back(argument.data());
      argv.push_back(nullptr);
      if (std::freopen(log.c_str(), "w", stdout) != nullptr)
        execv(PROSUP_PROGRAM, argv.data());
      _exit(127);
    }
    int status = 0;
    bool has_ended = false;
    while (!has_ended && !far_enough()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      has_ended = waitpid(child, &status, WNOHANG) == child;
    }
    if (!has_ended) {
      kill(child, signal);
      waitpid(child, &status, 0);
    }
    ASSERT_FALSE(has_ended) << "it ended before it was killed";
    ASSERT_TRUE(fs::exists(checkpoint("a.h5")) || fs::exists(checkpoint("b.h5")));
  }

  /// Damages one byte of the newer file.
  void damage_newer() const {
    const bool a_is_newer =
        !fs::exists(checkpoint("b.h5")) ||
        fs::last_write_time(checkpoint("a.h5")) > fs::last_write_time(checkpoint("b.h5"));
    std::fstream stream(checkpoint(a_is_newer ? "a.h5" : "b.h5"),
                        std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(4000);
    stream.put('x');
  }

  const TemporaryFolder folder_;
};

/// Largest distance between the nodes of two results, mm.
double distance(const fs::path& a, const fs::path& b) {
  double largest = 0.;
  for (const Position position : both_positions) {
    const std::string name = std::string(name_of(position)) + "_loaded.vtu";
    const auto first = output::read_mesh(a / name), second = output::read_mesh(b / name);
    EXPECT_EQ(first.mesh.cells, second.mesh.cells);
    EXPECT_EQ(first.unloaded.size(), second.unloaded.size());
    for (std::size_t i = 0; i < std::min(first.unloaded.size(), second.unloaded.size()); ++i)
      largest = std::max(largest, first.unloaded[i].distance(second.unloaded[i]));
  }
  return largest;
}

TEST_F(Restart, AKilledRunEndsWhereItWouldHave) {
  const auto& whole = SmallRegistration::on_ranks(1);
  run_until("Material update");
  run_until("Image forces"); // from the start, over what the first one left
  const ProgramRun run = run_prosup(arguments({"--restart"}));
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_NE(run.out.find("goes on from"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("Meshing"), std::string::npos) << run.out;
  EXPECT_LT(distance(output(), whole.folder), 1e-3);
  const Json summary = read_json(fs::path(output()) / "summary.json");
  for (const char* row : {"initial", "unloaded", "material", "image_forces"})
    EXPECT_NEAR(summary.at("tre").at(row).at("mean").get<double>(),
                whole.summary.at("tre").at(row).at("mean").get<double>(), 1e-3)
        << row;
  EXPECT_EQ(summary.at("steps"), whole.summary.at("steps"));
  EXPECT_EQ(summary.at("similarity").size(), whole.summary.at("similarity").size());
  EXPECT_FALSE(fs::exists(folder_ / "out.checkpoint"));

  const ProgramRun again = run_prosup(arguments({"--restart"}));
  EXPECT_EQ(again.exit_code, 1) << again.transcript();
  EXPECT_NE(again.err.find("has ended"), std::string::npos) << again.err;
}

TEST_F(Restart, GoesOnOnOtherRanksFromTheOlderFileIfTheNewerIsDamaged) {
  run_until("Image forces");
  ASSERT_TRUE(fs::exists(checkpoint("a.h5")) && fs::exists(checkpoint("b.h5")));
  damage_newer();
  const ProgramRun run = run_prosup(arguments({"--restart"}), 2);
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_NE(run.out.find("damaged"), std::string::npos) << run.out;
  // As far as ranks agree: the tolerance of the positions is 0.02 mm.
  EXPECT_LT(distance(output(), SmallRegistration::on_ranks(1).folder), 0.05);
}

TEST_F(Restart, WhatHasChangedIsNamed) {
  const auto expect_refused = [&](const std::vector<std::string>& more, const std::string& word) {
    const ProgramRun run = run_prosup(arguments(more));
    EXPECT_EQ(run.exit_code, 1) << run.transcript();
    EXPECT_NE(run.err.find(word), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  };
  run_until("Material update");
  expect_refused({"--restart", "--set", "Material/Shear modulus=400"}, "'Material/Shear modulus'");
  // Another file of the same contents is the same.
  const std::string copy = folder_ / "labels.nii.gz", other = folder_ / "other.csv";
  fs::copy(data_file("small/prone_labels.nii.gz"), copy);
  text_file(other, contents(data_file("small/landmarks.csv")) + "\n");
  expect_refused({"--restart", "--landmarks", other}, "'Case/Landmarks'");
  const ProgramRun run = run_prosup(arguments({"--restart", "--prone-labels", copy}));
  EXPECT_EQ(run.exit_code, 0) << run.transcript();
}

// Within the only stage of unload, after 200 steps.
TEST_F(Restart, AnUnloadingGoesOn) {
  const std::vector<std::string> fine{"--state", "prone",
                                      "--set",   "Meshing/Edge length=6",
                                      "--set",   "Unloading/Position tolerance=1e-4"};
  const auto unload = [&](const std::string& output, const std::vector<std::string>& more) {
    std::vector<std::string> all{"unload",   PROSUP_PRM_FOLDER "/tests/small.prm",
                                 "--output", output,
                                 "--set",    "Checkpoint/Interval=0"};
    all.insert(all.end(), fine.begin(), fine.end());
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const ProgramRun whole = run_prosup(unload(folder_ / "whole", {}));
  ASSERT_EQ(whole.exit_code, 0) << whole.transcript();
  run_until(unload(output(), {}), [&] { return fs::exists(checkpoint("b.h5")); });
  const ProgramRun run = run_prosup(unload(output(), {"--restart"}));
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_NE(run.out.find("goes on from"), std::string::npos) << run.out;
  const auto read = [&](const std::string& folder) {
    return output::read_mesh(fs::path(folder) / "prone_loaded.vtu").unloaded;
  };
  const auto a = read(folder_ / "whole"), b = read(output());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_LT(a[i].distance(b[i]), 1e-3);
  EXPECT_EQ(read_json(folder_ / "whole/summary.json").at("steps"),
            read_json(output() + "/summary.json").at("steps"));
}

TEST_F(Restart, AnEndedRunLeavesItsLogBesideItsState) {
  run_until(
      arguments({"--quiet"}), [&] { return fs::exists(checkpoint("b.h5")); }, SIGTERM);
  EXPECT_EQ(contents(folder_ / "log"), "") << "it was to be quiet";
  const std::string log = contents(checkpoint("log_of_failed_run.txt"));
  EXPECT_NE(log.find("  Meshing\n"), std::string::npos) << log;
  EXPECT_NE(log.find("  Error: The run was ended.\n"), std::string::npos) << log;
  EXPECT_FALSE(fs::exists(output()));
}

TEST_F(Restart, WithoutACheckpointItBegins) {
  const ProgramRun run = run_prosup(arguments({"--restart"}));
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_NE(run.out.find("There is no checkpoint"), std::string::npos) << run.out;
  EXPECT_LT(distance(output(), SmallRegistration::on_ranks(1).folder), 1e-3);
}

} // namespace
} // namespace prosup::tests
