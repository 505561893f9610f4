#include "prosup/core/result_marker.h"
#include "small_registration.h"

namespace prosup::tests {
namespace {

class ReportCommand : public ::testing::Test {
protected:
  ReportCommand() {
    std::filesystem::copy(SmallRegistration::on_ranks(1).folder, result_,
                          std::filesystem::copy_options::recursive);
  }
  ProgramRun report(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"report", result_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_prosup(arguments);
  }

  const TemporaryFolder folder_;
  const std::filesystem::path result_ = folder_ / "copy";
  const std::filesystem::path file_ = result_ / "report.html";
};

TEST_F(ReportCommand, MakesThePageOfTheRunAnew) {
  const std::string first = contents(file_);
  EXPECT_NE(first.find("Verdict: good"), std::string::npos);
  EXPECT_NE(first.find("type=\"range\""), std::string::npos);
  std::filesystem::remove(file_);
  const ProgramRun run = report();
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_EQ(contents(file_), first);
}

// One that somebody has written notes into is not lost; one that prosup wrote is its own.
TEST_F(ReportCommand, ReplacesOnlyWhatProsupHasWritten) {
  text_file(file_, "notes");
  ProgramRun run = report();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("--overwrite"), std::string::npos) << run.err;
  EXPECT_EQ(contents(file_), "notes");
  run = report({"--overwrite"});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  const auto marker = ResultMarker::read(result_);
  ASSERT_TRUE(marker);
  EXPECT_TRUE(marker->owns(result_, "report.html"));
  EXPECT_EQ(report().exit_code, 0);
}

TEST_F(ReportCommand, DoesWithoutInputsThatAreGone) {
  std::string used = contents(result_ / "used.prm");
  const std::string name = "small/prone.nii.gz";
  used.replace(used.find(name), name.size(), "small/moved.nii.gz");
  text_file(result_ / "used.prm", used);
  const ProgramRun run = report();
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_NE((run.out + run.err).find("moved.nii.gz"), std::string::npos) << run.transcript();
  EXPECT_NE(contents(file_).find("no slices to compare"), std::string::npos);
}

TEST_F(ReportCommand, OfNoResultIsRefused) {
  const ProgramRun run = run_prosup({"report", PROSUP_TEST_DATA});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("no finished registration"), std::string::npos) << run.err;
}

// A cohort in which one case has failed is no failure of the table, and it may be made again.
TEST_F(ReportCommand, TableHasARowForEachFolder) {
  for (const char* name : {"table.csv", "table.html"})
    for (unsigned n = 0; n < 2; ++n) {
      const ProgramRun run = run_prosup({"table", result_, folder_ / "none", "-o", folder_ / name});
      ASSERT_EQ(run.exit_code, 0) << run.transcript();
      EXPECT_NE(run.err.find("1 of 2 folders"), std::string::npos) << run.err;
    }
  const std::string rows = contents(folder_ / "table.csv");
  EXPECT_NE(rows.find("\ncopy,finished,good,"), std::string::npos) << rows;
  EXPECT_NE(contents(folder_ / "table.html").find("href=\"copy/report.html\""), std::string::npos);
  EXPECT_EQ(run_prosup({"table", result_, folder_ / "none"}).out.substr(0, 10), "name,state");
  EXPECT_EQ(run_prosup({"table", result_, "-o", folder_ / "table.txt"}).exit_code, 1);
}

} // namespace
} // namespace prosup::tests
