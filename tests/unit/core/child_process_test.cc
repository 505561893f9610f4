#include "prosup/core/child_process.h"

#include <gtest/gtest.h>

#include "expect_error.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

TEST(ChildProcess, LeavesItsOutputInFilesAndItsExitCode) {
  const TemporaryFolder folder;
  const ChildResult result =
      run_child({"sh", "-c", "echo said; echo wrong >&2; exit 3"}, folder / "log");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(contents(folder / "log.out"), "said\n");
  EXPECT_EQ(contents(folder / "log.err"), "wrong\n");
}

TEST(ChildProcess, GetsItsArgumentsAsTheyAre) {
  const TemporaryFolder folder;
  run_child({"printf", "%s|", "two words", "$HOME", "*", "a;b"}, folder / "log");
  EXPECT_EQ(contents(folder / "log.out"), "two words|$HOME|*|a;b|");
}

TEST(ChildProcess, IsTimedAsAWhole) {
  const TemporaryFolder folder;
  const double seconds = run_child({"sleep", "0.3"}, folder / "log").wall_seconds;
  EXPECT_GE(seconds, 0.3);
  EXPECT_LT(seconds, 3.); // a loaded machine takes longer to start it
}

TEST(ChildProcess, TellsItsPeakMemory) {
  const TemporaryFolder folder;
  constexpr double mebibytes = 200.;
  const ChildResult result =
      run_child({"dd", "if=/dev/zero", "of=/dev/null", "bs=200M", "count=3"}, folder / "log");
  ASSERT_EQ(result.exit_code, 0);
  EXPECT_GT(result.peak_memory, mebibytes);
  EXPECT_LT(result.peak_memory, mebibytes + 20.);
}

TEST(ChildProcess, TellsTheSignalThatEndedIt) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_child({"sh", "-c", "kill -9 $$"}, folder / "log").exit_code, 128 + 9);
}

TEST(ChildProcess, HasTheVariablesItIsGivenAndNoneThatWereSetLater) {
  const TemporaryFolder folder;
  ::setenv("PROSUP_SET_LATER", "yes", 1);
  run_child({"sh", "-c", "echo $PROSUP_GIVEN,$PROSUP_SET_LATER,${PATH:+path}"}, folder / "log",
            {"PROSUP_GIVEN=3"});
  EXPECT_EQ(contents(folder / "log.out"), "3,,path\n");
}

TEST(ChildProcess, ThatDoesNotExistIsAnError) {
  const TemporaryFolder folder;
  expect_error([&] { run_child({"no-such-program"}, folder / "log"); },
               {"no-such-program", "installed"});
  EXPECT_TRUE(find_program("no-such-program").empty());
  EXPECT_FALSE(find_program("sh").empty());
}

} // namespace
} // namespace prosup::tests
