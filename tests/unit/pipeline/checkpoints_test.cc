#include "pipeline/checkpoints.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <fstream>

#include "expect_error.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

namespace fs = std::filesystem;
using namespace prosup::pipeline;

/// A run of two parameters and a file, in a folder that all ranks share.
class CheckpointFiles : public ::testing::Test {
protected:
  CheckpointFiles() {
    path_ = dealii::Utilities::MPI::broadcast(world_, (own_ / "").string());
    set_input("labels");
    all_.enter_subsection("Case");
    all_.declare_entry("Prone labels", (path_ / "labels").string());
    all_.leave_subsection();
    all_.enter_subsection("Material");
    all_.declare_entry("Shear modulus", "300");
    all_.leave_subsection();
    parameters_.interval = 0.;
  }
  ~CheckpointFiles() override { MPI_Barrier(world_); }

  void set_input(const std::string& text) const {
    on_first([&] { text_file(path_ / "labels", text); });
  }

  template <typename Work>
  void on_first(const Work& work) const {
    MPI_Barrier(world_);
    if (dealii::Utilities::MPI::this_mpi_process(world_) == 0)
      work();
    MPI_Barrier(world_);
  }

  std::unique_ptr<Checkpoints> run(bool goes_on = false) {
    parameters_.restart = goes_on;
    return std::make_unique<Checkpoints>("test", parameters_, all_, path_ / "out", world_, log_,
                                         remarks_);
  }

  /// Keeps a number.
  static void keep(Checkpoints& checkpoints, double number) {
    checkpoints.keep([&](output::Hdf5Writer& file) { file.number("number", number); });
  }

  /// What a run that goes on finds.
  double found() {
    const auto file = run(true)->restart();
    return file ? file->number("number") : -1.;
  }

  fs::path file(const char* name) const { return path_ / "out.checkpoint" / name; }

  MPI_Comm world_ = MPI_COMM_WORLD;
  const TemporaryFolder own_;
  fs::path path_;
  dealii::ParameterHandler all_;
  CheckpointParameters parameters_;
  const Log log_;
  Remarks remarks_;
};

TEST_F(CheckpointFiles, TheNewestIsFound) {
  EXPECT_EQ(found(), -1.);
  const auto checkpoints = run();
  EXPECT_EQ(checkpoints->restart(), nullptr);
  for (const double number : {1., 2., 3.}) {
    keep(*checkpoints, number);
    EXPECT_EQ(found(), number);
  }
  EXPECT_TRUE(remarks_.all().empty());
  EXPECT_TRUE(fs::exists(file("a.h5")) && fs::exists(file("b.h5")));
  MPI_Barrier(world_);
  checkpoints->remove();
  MPI_Barrier(world_);
  EXPECT_FALSE(fs::exists(file("")));
}

TEST_F(CheckpointFiles, ARunThatGoesOnLeavesTheOneItCameFrom) {
  auto checkpoints = run();
  checkpoints->restart();
  for (const double number : {1., 2., 3.}) // a, b, a
    keep(*checkpoints, number);
  checkpoints = run(true);
  checkpoints->restart();
  keep(*checkpoints, 4.); // to b
  EXPECT_EQ(found(), 4.);
  on_first([&] { fs::resize_file(file("b.h5"), 1000); });
  EXPECT_EQ(found(), 3.);
}

TEST_F(CheckpointFiles, ANewRunTakesThePlaceOfAnOldOne) {
  auto checkpoints = run();
  checkpoints->restart();
  for (const double number : {1., 2., 3.})
    keep(*checkpoints, number);
  checkpoints = run();
  checkpoints->restart();
  EXPECT_EQ(found(), 3.) << "before it has written one of its own";
  keep(*checkpoints, 10.);
  EXPECT_EQ(found(), 10.);
  MPI_Barrier(world_);
  EXPECT_FALSE(fs::exists(file("b.h5")));
}

TEST_F(CheckpointFiles, OnlyDamagedOnesAreRefused) {
  const auto checkpoints = run();
  checkpoints->restart();
  keep(*checkpoints, 1.);
  on_first([&] { text_file(file("a.h5"), "x"); });
  expect_error([&] { found(); }, {"a.h5", "damaged", "run without --restart"});
}

TEST_F(CheckpointFiles, WhatHasChangedIsNamed) {
  const auto checkpoints = run();
  checkpoints->restart();
  keep(*checkpoints, 1.);
  all_.enter_subsection("Material");
  all_.set("Shear modulus", "400");
  all_.leave_subsection();
  expect_error([&] { found(); }, {"'Material/Shear modulus'", "'400'", "'300'", "a.h5"});
  all_.enter_subsection("Material");
  all_.set("Shear modulus", "300");
  all_.leave_subsection();
  set_input("other labels");
  expect_error([&] { found(); }, {"'Case/Prone labels'", "a.h5", "old file"});
  set_input("labels");
  EXPECT_EQ(found(), 1.);
}

TEST_F(CheckpointFiles, AreWrittenOnceInAnInterval) {
  parameters_.interval = 1000.;
  const auto checkpoints = run();
  checkpoints->restart();
  keep(*checkpoints, 1.);
  EXPECT_FALSE(fs::exists(file("a.h5")));
}

TEST_F(CheckpointFiles, AFolderThatCannotBeMadeIsAWarning) {
  on_first([&] { text_file(path_ / "out.checkpoint", "a file"); });
  const auto checkpoints = run();
  checkpoints->restart();
  keep(*checkpoints, 1.);
  on_first([&] {
    ASSERT_EQ(remarks_.all().size(), 1u);
    EXPECT_NE(remarks_.all()[0].find("No checkpoint was written"), std::string::npos);
  });
}

TEST_F(CheckpointFiles, ARunThatHasEndedIsNotRepeated) {
  on_first([&] {
    fs::create_directories(path_ / "out");
    text_file(path_ / "out/summary.json", "{}");
  });
  expect_error([&] { found(); }, {"has ended", "run without --restart"});
}

} // namespace
} // namespace prosup::tests
