#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "prosup/output/registration_file.h"
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

  /// Starts the run and kills it once it has said `word`, if it does not end before.
  void run_until(const std::string& word) const {
    const std::string log = folder_ / "log";
    const pid_t child = fork();
    if (child == 0) {
      std::vector<std::string> words = arguments();
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
    while (!has_ended && contents(log).find(word) == std::string::npos) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      has_ended = waitpid(child, &status, WNOHANG) == child;
    }
    if (!has_ended) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
    }
    ASSERT_TRUE(WIFSIGNALED(status)) << "it was not killed before '" << word << "'";
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
    const auto first = output::read_registration(a / output::registration_h5, position),
               second = output::read_registration(b / output::registration_h5, position);
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

TEST_F(Restart, WithoutACheckpointItBegins) {
  const ProgramRun run = run_prosup(arguments({"--restart"}));
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_NE(run.out.find("There is no checkpoint"), std::string::npos) << run.out;
  EXPECT_LT(distance(output(), SmallRegistration::on_ranks(1).folder), 1e-3);
}

} // namespace
} // namespace prosup::tests
