#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "program.h"
#include "prosup/core/version.h"

namespace prosup::tests {
namespace {

const std::vector<std::string> commands{"register", "unload",  "load", "mesh",
                                        "phantom",  "compare", "map",  "prepare"};

std::vector<std::filesystem::path> shipped_parameter_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(PROSUP_PRM_FOLDER))
    if (entry.path().extension() == ".prm")
      files.push_back(entry.path());
  return files;
}

/// Value of the first line "set <entry> = value # default: ..." of a file.
std::string value_of(const std::string& prm, const std::string& entry) {
  std::smatch match;
  const std::regex line("set " + entry + " *= *(.*?) *(#|\\n)");
  return std::regex_search(prm, match, line) ? match[1].str() : "";
}

TEST(Help, OfEachCommandNamesItsOptions) {
  const ProgramRun program = run_prosup({"--help"});
  EXPECT_EQ(program.exit_code, 0);
  EXPECT_TRUE(program.err.empty()) << program.err;
  for (const std::string& command : commands) {
    EXPECT_NE(program.out.find(command), std::string::npos) << command;
    const ProgramRun run = run_prosup({command, "--help"});
    EXPECT_EQ(run.exit_code, 0) << command;
    EXPECT_TRUE(run.err.empty()) << run.err;
    EXPECT_NE(run.out.find("--output"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find(command == "map" ? "--from" : "--write-prm"), std::string::npos)
        << run.out;
  }
}

TEST(Help, OfACommandListsWhatItTakesAndNothingElse) {
  const std::vector<std::string> all{
      "--prone-image",   "--supine-image", "--prone-labels", "--supine-labels", "--landmarks",
      "--prone-gravity", "--chest",        "--method",       "--similarity",    "--state"};
  const std::map<std::string, std::set<std::string>> not_taken{
      {"register", {"--state"}},
      {"check", {"--state"}},
      {"unload", {"--similarity"}},
      {"load", {"--similarity", "--landmarks"}},
      {"mesh",
       {"--prone-image", "--supine-image", "--landmarks", "--prone-gravity", "--chest", "--method",
        "--similarity"}},
      {"prepare", {all.begin(), all.end()}},
      {"compare", {}}};
  for (const auto& [command, absent] : not_taken) {
    const std::string help = run_prosup({command, "--help"}).out;
    for (const std::string& option : all)
      EXPECT_EQ(help.find(option) != std::string::npos, absent.count(option) == 0)
          << option << " in " << help;
  }
}

TEST(Help, OfTheCheckTakesNoFolderForResults) {
  EXPECT_EQ(run_prosup({"check", "--help"}).out.find("--output"), std::string::npos);
}

TEST(Help, TellsDefaultsAndChoices) {
  const std::string help = run_prosup({"register", "--help"}).out;
  // CLI11 writes a default as =sliding, and from version 2.4 on as [sliding].
  for (const char* text :
       {"--chest TEXT(=| \\[)sliding", "fixed, sliding, one-sided", "--method TEXT(=| \\[)fe",
        "fe, fdm", "--similarity TEXT(=| \\[)automatic", "ssd, nmi, lncc", "(=|\\[)results"})
    EXPECT_TRUE(std::regex_search(help, std::regex(text))) << text << " in " << help;
}

TEST(Version, OfEachCommandIsThatOfTheLibrary) {
  const auto expect_version = [](const std::vector<std::string>& arguments) {
    const ProgramRun run = run_prosup(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.transcript();
    EXPECT_NE(run.out.find(version()), std::string::npos) << run.transcript();
  };
  expect_version({"--version"});
  for (const std::string& command : commands)
    expect_version({command, "--version"});
}

TEST(Help, IsPrintedOnceByTwoRanks) {
  const ProgramRun run = run_prosup({"register", "--help"}, 2);
  EXPECT_EQ(run.exit_code, 0);
  const std::size_t first = run.out.find("--write-prm");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(run.out.find("--write-prm", first + 1), std::string::npos) << run.out;
}

TEST(WritePrm, HoldsEveryDefaultAndCanBeReadBack) {
  const TemporaryFolder folder;
  const std::string first = folder / "first.prm", second = folder / "second.prm";
  ASSERT_EQ(run_prosup({"register", "--write-prm", first}).exit_code, 0);
  const ProgramRun run = run_prosup({"unload", first, "--write-prm", second});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_EQ(contents(first), contents(second));
  for (const char* text : {"subsection Case", "subsection Unloading", "Units: Pa", "Units: mm"})
    EXPECT_NE(contents(first).find(text), std::string::npos) << text;
}

// Where this fails, write the page anew with
// `prosup register --write-prm docs/parameters.md --overwrite`.
TEST(WritePrm, MakesTheReferenceOfAllParameters) {
  const TemporaryFolder folder;
  const ProgramRun run = run_prosup({"register", "--write-prm", folder / "parameters.md"});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_EQ(contents(folder / "parameters.md"),
            contents(PROSUP_PRM_FOLDER "/../docs/parameters.md"));
}

TEST(WritePrm, HoldsTheOverridesAndOptions) {
  const TemporaryFolder folder;
  const std::string file = folder / "all.prm";
  const ProgramRun run = run_prosup(
      {"register", "--prone-image", "some/where.nrrd", "--supine-gravity", "0,0.6,0.8", "--set",
       "Unloading/Lag factor=1.5", "--set", "Unloading/Lag factor=2", "--write-prm", file});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  const std::string prm = contents(file);
  EXPECT_EQ(value_of(prm, "Lag factor"), "2"); // the last one counts
  EXPECT_EQ(value_of(prm, "Supine gravity"), "0,0.6,0.8");
  EXPECT_EQ(value_of(prm, "Prone image"), std::filesystem::absolute("some/where.nrrd"));
}

// A written file may lie elsewhere than the one that was read, so that it holds
// file names that do not depend on its place.
TEST(ShippedParameters, AreReadAndNameFilesThatExist) {
  const auto files = shipped_parameter_files();
  ASSERT_GE(files.size(), 2u);
  for (const auto& file : files) {
    const TemporaryFolder folder;
    const std::string copy = folder / "copy.prm";
    const ProgramRun run = run_prosup({"register", file, "--write-prm", copy});
    ASSERT_EQ(run.exit_code, 0) << file << "\n" << run.transcript();
    for (const char* entry :
         {"Prone image", "Prone labels", "Supine image", "Supine labels", "Landmarks"})
      if (const std::string named = value_of(contents(copy), entry); !named.empty()) {
        EXPECT_TRUE(std::filesystem::is_regular_file(named))
            << file << ": " << entry << " = " << named;
      }
  }
}

} // namespace
} // namespace prosup::tests
