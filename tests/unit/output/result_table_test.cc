#include "prosup/output/result_table.h"

#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::output;

const char* const summary = R"({"version": "7.8.9", "command": "register", "metric": "ssd",
  "quality": {"verdict": "doubtful", "reasons": ["The <skin>, here.", "And so on."]},
  "material": {"shear_modulus": 300.5}, "time": {"total": 20.0},
  "tre": {"initial": {"mean": 10.5, "max": 20, "n": 2},
          "image_forces": {"mean": 0.75, "max": 1.25, "n": 2}}})";

class ResultTables : public ::testing::Test {
protected:
  std::filesystem::path result(const std::string& name, const std::string& contents) const {
    std::filesystem::create_directories(folder_ / name);
    text_file(folder_ / name / "summary.json", contents);
    return folder_ / name;
  }
  ResultTable table(const std::vector<std::filesystem::path>& results) const {
    return {results,
            {{"/material/shear_modulus", "shear_modulus", "Shear modulus, Pa"},
             {"/material/skin_stiffness", "skin_stiffness", "Skin stiffness, Pa mm"}}};
  }

  const TemporaryFolder folder_;
};

TEST_F(ResultTables, HaveARowForEachFinishedRegistration) {
  const auto one = result("one", summary);
  EXPECT_EQ(
      table({one}).csv(),
      "name,state,verdict,reasons,tre_initial_mean_mm,tre_mean_mm,tre_max_mm,landmarks,time_s,"
      "shear_modulus,skin_stiffness,metric,version,folder\n"
      "one,finished,doubtful,\"The <skin>, here. And so on.\",10.5,0.75,1.25,2,20,300.5,,ssd,"
      "7.8.9," +
          one.string() + "\n");
  EXPECT_EQ(table({one}).n_unfinished(), 0u);
}

TEST_F(ResultTables, SayWhereThereIsNoResult) {
  std::filesystem::create_directories(folder_ / "empty");
  std::filesystem::create_directories(folder_ / ".new.incomplete");
  std::filesystem::create_directories(folder_ / "kept.checkpoint");
  const ResultTable all =
      table({folder_ / "none", folder_ / "empty", folder_ / "new", folder_ / "kept",
             result("damaged", "{\"quality"),
             result("odd", R"({"quality": {"verdict": 3, "reasons": 4}, "tre": 5, "time": "x"})"),
             result("mesh", R"({"command": "mesh"})"), result("fine", summary)});
  EXPECT_EQ(all.n_unfinished(), 6u);
  const std::string csv = all.csv();
  for (const char* row :
       {"none,unfinished,,\"There is no such folder",
        "empty,unfinished,,The folder holds no summary",
        "new,unfinished,,\"A run into this folder is going on",
        "kept,unfinished,,A run failed or was ended; its last state and its log are in kept",
        "damaged,unreadable,,\"Its summary", "odd,finished,,,,,,,,",
        "mesh,unreadable,,\"Its summary", "fine,finished,doubtful,"})
    EXPECT_NE(csv.find(std::string("\n") + row), std::string::npos) << row << " in " << csv;
}

TEST_F(ResultTables, AreNoFormulasForASpreadsheet) {
  const std::string csv = table({result("=1+2", summary), folder_ / "@,\"x"}).csv();
  EXPECT_NE(csv.find("\n'=1+2,finished"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\n\"'@,\"\"x\",unfinished"), std::string::npos) << csv;
}

TEST_F(ResultTables, KeepResultsOfOneNameApart) {
  const auto one = result("a/case", summary), other = result("b/case", summary);
  const std::string csv = table({one, other}).csv();
  EXPECT_NE(csv.find("\n" + one.string() + ",finished"), std::string::npos) << csv;
}

TEST_F(ResultTables, LinkToTheReportsFromTheirPage) {
  const auto one = result("one #1 <x>", summary);
  text_file(one / "report.html", "");
  std::filesystem::create_directories(folder_ / "pages");
  const std::string page = table({one, folder_ / "none"}).html(folder_ / "pages");
  for (const char* part :
       {"<a href=\"../one%20%231%20%3Cx%3E/report.html\">one #1 &lt;x&gt;</a>",
        "The &lt;skin&gt;, here.", "2 results: 0 good, 1 doubtful, 0 failed, 1 without",
        "Shear modulus, Pa", "<td>none</td><td>unfinished</td>"})
    EXPECT_NE(page.find(part), std::string::npos) << part << " in " << page;
  EXPECT_EQ(page.rfind(ResultTable::page_mark, 0), 0u);
  EXPECT_EQ(page.find("Skin stiffness"), std::string::npos) << "a column without values";
}

} // namespace
} // namespace prosup::tests
