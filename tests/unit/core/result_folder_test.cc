#include "prosup/core/result_folder.h"

#include <gtest/gtest.h>

#include <fstream>

#include "prosup/core/error.h"
#include "temporary_folder.h"

namespace prosup::tests {
namespace {

namespace fs = std::filesystem;
using prosup::Error;
using prosup::ResultFolder;

std::size_t n_entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(ResultFolder, AppearsOnlyWhenCommitted) {
  const TemporaryFolder here;
  const fs::path target = here / "result";
  {
    ResultFolder folder(target);
    std::ofstream(folder.path() / "summary.json") << "{}";
    EXPECT_FALSE(fs::exists(target));
  }
  EXPECT_EQ(n_entries(here / ""), 0u); // abandoned: nothing is left
  ResultFolder folder(target);
  std::ofstream(folder.path() / "summary.json") << "{}";
  folder.commit();
  EXPECT_TRUE(fs::exists(target / "summary.json"));
  EXPECT_EQ(n_entries(here / ""), 1u);
}

TEST(ResultFolder, ReplacesAnEarlierResultAndNothingElse) {
  const TemporaryFolder here;
  const fs::path target = here / "result/"; // with a slash at the end
  for (const char* name : {"first", "second"}) {
    ResultFolder folder(target);
    std::ofstream(folder.path() / "summary.json") << "{}";
    std::ofstream(folder.path() / name) << name;
    folder.commit();
  }
  EXPECT_FALSE(fs::exists(target / "first"));
  EXPECT_TRUE(fs::exists(target / "second"));

  fs::create_directory(here / "foreign");
  std::ofstream(here / "foreign/thesis.tex") << "x";
  EXPECT_THROW(ResultFolder(here / "foreign"), Error);
  EXPECT_TRUE(fs::exists(here / "foreign/thesis.tex"));
  std::ofstream(here / "file") << "x";
  EXPECT_THROW(ResultFolder(here / "file"), Error);
}

} // namespace
} // namespace prosup::tests
