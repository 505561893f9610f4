#include "prosup/core/result_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "expect_error.h"
#include "prosup/core/error.h"
#include "prosup/core/result_marker.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

namespace fs = std::filesystem;
using prosup::Error;
using prosup::ResultFolder;

using Files = std::vector<std::string>;

std::size_t n_entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

/// Writes a result with these files, each of which holds `text`.
void write_result(const ResultTarget& target, const std::string& text,
                  const Files& names = {"summary.json", "field.nrrd"}) {
  ResultFolder folder(target, names);
  for (const std::string& name : names) {
    fs::create_directories((folder.path() / name).parent_path());
    text_file(folder.path() / name, text);
  }
  folder.commit();
}

/// Expects that a result cannot go to `target` and that nothing changes there.
void expect_refused(const ResultTarget& target, const std::vector<std::string>& key_words,
                    const Files& names = {"summary.json", "field.nrrd"}) {
  const std::size_t n_before = n_entries(target.folder);
  expect_error([&] { const ResultFolder folder(target, names); }, key_words);
  EXPECT_EQ(n_entries(target.folder), n_before);
}

TEST(ResultFolder, AppearsOnlyWhenCommitted) {
  const TemporaryFolder here;
  const fs::path target = here / "result";
  {
    const ResultFolder folder(target);
    text_file(folder.path() / "summary.json", "{}");
    EXPECT_FALSE(fs::exists(target));
  }
  EXPECT_EQ(n_entries(here / ""), 0u); // abandoned: nothing is left
  write_result(target, "{}");
  EXPECT_TRUE(fs::exists(target / "summary.json"));
  EXPECT_EQ(n_entries(here / ""), 1u);
}

TEST(ResultFolder, ReplacesAnEarlierResultAndNothingElse) {
  const TemporaryFolder here;
  const fs::path target = here / "result/"; // with a slash at the end
  write_result(target, "1", {"summary.json", "first", "logs/run.out"});
  text_file(target / "notes.txt", "precious");
  fs::create_directory(target / ".git");
  text_file(target / ".git/config", "precious");
  write_result(target, "2", {"summary.json", "second"});
  EXPECT_FALSE(fs::exists(target / "first"));
  EXPECT_FALSE(fs::exists(target / "logs"));
  EXPECT_EQ(contents(target / "second"), "2");
  EXPECT_EQ(contents(target / "notes.txt"), "precious");
  EXPECT_EQ(contents(target / ".git/config"), "precious");
  EXPECT_EQ(n_entries(target), 5u); // with the marker
}

TEST(ResultFolder, RefusesToReplaceWhatItDidNotWrite) {
  const TemporaryFolder here;
  const fs::path target = here / "case";
  fs::create_directory(target);
  text_file(target / "summary.json", "of another program");
  expect_refused(target, {"case", "'summary.json' is", "--overwrite", "--output"});
  text_file(target / "field.nrrd", "mine");
  expect_refused(target, {"and others (2 files) are"});
  text_file(target / "notes.txt", "mine");
  write_result({target, true}, "new");
  EXPECT_EQ(contents(target / "field.nrrd"), "new");
  EXPECT_EQ(contents(target / "notes.txt"), "mine");
  text_file(here / "file", "x");
  EXPECT_THROW(ResultFolder(here / "file"), Error);
}

TEST(ResultFolder, RefusesToReplaceWhatHasChangedSince) {
  const TemporaryFolder here;
  const fs::path target = here / "result";
  write_result(target, "old");
  text_file(target / "field.nrrd", "odl"); // of the same size
  expect_refused(target, {"'field.nrrd' is"});
  write_result(target, "new", {"summary.json", "other"});
  EXPECT_EQ(contents(target / "field.nrrd"), "odl"); // no longer written, and not removed either
  expect_refused(target, {"'field.nrrd' is"});
  write_result({target, true}, "new");
  EXPECT_EQ(contents(target / "field.nrrd"), "new");
}

TEST(ResultFolder, RefusesAFolderWhereAFileGoesWhateverIsAllowed) {
  const TemporaryFolder here;
  const fs::path target = here / "result";
  fs::create_directories(target / "field.nrrd");
  text_file(target / "field.nrrd/precious", "x");
  expect_refused({target, true}, {"'field.nrrd'"});
  fs::create_directory(here / "elsewhere");
  fs::create_directory_symlink(here / "elsewhere", target / "logs");
  expect_refused({target, true}, {"'logs/run.out'"}, {"logs/run.out"});
  text_file(target / "logs/run.out", "x");
  expect_refused(target, {"logs"}, {"logs/"});
}

TEST(ResultFolder, RefusesAnInput) {
  const TemporaryFolder here;
  const fs::path target = here / "result";
  write_result(target, "old", {"summary.json", "prone.nii.gz", "mesh.vtu"});
  const Files names{"summary.json", "prone.nii.gz"};
  for (const char* name : {"prone.nii.gz", "mesh.vtu"}) { // the second would be removed
    expect_refused({target, true, {"", "nowhere", target / name}}, {name, "input"}, names);
    fs::create_symlink(target / name, here / "link");
    expect_refused({target, true, {here / "link"}}, {name}, names);
    fs::remove(here / "link");
    fs::create_hard_link(target / name, here / "link");
    expect_refused({target, true, {here / "link"}}, {name}, names);
    fs::remove(here / "link");
  }
}

TEST(ResultFolder, IsWrittenThroughLinks) {
  const TemporaryFolder here;
  fs::create_directory(here / "disk");
  fs::create_directory_symlink(here / "disk", here / "there");
  fs::create_directory_symlink("disk/new", here / "not yet");
  for (const char* link : {"there", "not yet"})
    for (const char* text : {"1", "2"}) {
      write_result(here / link, text);
      EXPECT_TRUE(fs::is_symlink(here / link));
      EXPECT_EQ(contents(here / link / "summary.json"), text);
    }
  EXPECT_EQ(contents(here / "disk/new/summary.json"), "2");
  fs::create_directory_symlink(here / "b", here / "a");
  fs::create_directory_symlink(here / "a", here / "b");
  EXPECT_THROW(ResultFolder(here / "a"), Error);
}

// A link among the files is somebody's own, and what it leads to is not touched.
TEST(ResultFolder, ReplacesALinkAndNotWhatItLeadsTo) {
  const TemporaryFolder here;
  text_file(here / "mine", "precious");
  fs::create_directory(here / "result");
  fs::create_symlink(here / "mine", here / "result/summary.json");
  expect_refused(here / "result", {"'summary.json' is"});
  write_result({here / "result", true}, "new");
  EXPECT_EQ(contents(here / "mine"), "precious");
  EXPECT_EQ(contents(here / "result/summary.json"), "new");
}

TEST(ResultFolder, MayBeTheCurrentFolder) {
  const TemporaryFolder here;
  const fs::path before = fs::current_path();
  fs::current_path(here / "");
  text_file("notes.txt", "precious");
  for (const char* text : {"1", "2"})
    write_result(fs::path("."), text);
  EXPECT_EQ(contents("summary.json"), "2");
  EXPECT_EQ(contents("notes.txt"), "precious");
  fs::current_path(before);
}

TEST(ResultFolder, MayHaveAnyName) {
  const TemporaryFolder here;
  std::string long_name;
  for (unsigned i = 0; i < 127; ++i)
    long_name += "ü";
  for (const std::string& name : {std::string("a b"), std::string("ü #1 %s %"), long_name + "x"})
    for (const char* text : {"1", "2"}) {
      write_result(here / name, text);
      EXPECT_EQ(contents(here / name / "summary.json"), text);
    }
  EXPECT_EQ(n_entries(here / ""), 3u);
  EXPECT_THROW(ResultFolder(here / (long_name + "xy")), Error); // before anything is computed
}

TEST(ResultFolder, IsForOneAtATime) {
  const TemporaryFolder here;
  for (unsigned i = 0; i < 2; ++i) { // a new folder, and one that is there
    ResultFolder first(here / "result", {"summary.json"});
    text_file(first.path() / "summary.json", "first");
    expect_error([&] { const ResultFolder second(here / "result", {"summary.json"}); },
                 {"Another run", std::to_string(getpid())});
    EXPECT_FALSE(ResultFolder::clear_leftover(here / "result"));
    first.commit();
    EXPECT_EQ(contents(here / "result/summary.json"), "first");
  }
}

TEST(ResultFolder, ClearsAwayWhatAKilledProcessLeft) {
  const TemporaryFolder here;
  const fs::path target = here / "result";
  for (unsigned i = 0; i < 2; ++i) { // a new folder, and one that is there
    const pid_t child = fork();
    if (child == 0) {
      const ResultFolder folder(target);
      text_file(folder.path() / "summary.json", "half");
      _exit(0); // without destructors
    }
    waitpid(child, nullptr, 0);
    const fs::path place = i == 0 ? fs::path(here / "") : target;
    const std::size_t n_left = n_entries(place);
    write_result(target, "whole");
    EXPECT_EQ(n_entries(here / ""), 1u);
    EXPECT_EQ(n_entries(place), i == 0 ? 1u : n_left - 1);
    EXPECT_EQ(contents(target / "summary.json"), "whole");
  }
}

TEST(ResultFolder, LeavesAFolderAloneThatIsNotItsOwn) {
  const TemporaryFolder here;
  fs::create_directory(here / ".result.incomplete");
  text_file(here / ".result.incomplete/precious", "x");
  EXPECT_THROW(ResultFolder(here / "result"), Error);
  EXPECT_TRUE(fs::exists(here / ".result.incomplete/precious"));
}

// Stopped between removing summary.json and the end: files of both results, all in the marker.
TEST(ResultFolder, GoesOnAfterAReplacementThatWasInterrupted) {
  const TemporaryFolder here;
  const fs::path target = here / "result";
  write_result(target, "old", {"summary.json", "a", "b", "only_old"});
  const ResultMarker old = ResultMarker::read(target).value();
  write_result(here / "next", "new", {"summary.json", "a", "b"});
  ResultMarker both = ResultMarker::read(here / "next").value();
  both.complete = false;
  both.files.insert(both.files.end(), old.files.begin(), old.files.end());
  both.write(target);
  fs::remove(target / "summary.json");
  text_file(target / "a", "new");
  write_result(target, "newest", {"summary.json", "a", "b"});
  for (const char* name : {"summary.json", "a", "b"})
    EXPECT_EQ(contents(target / name), "newest");
  EXPECT_FALSE(fs::exists(target / "only_old"));
  EXPECT_TRUE(ResultMarker::read(target).value().complete);
}

TEST(ResultFolder, KeepsResultsAsideIfSomethingGotInTheirWay) {
  const TemporaryFolder here;
  const fs::path target = here / "result";
  for (const bool is_there : {false, true}) {
    ResultFolder folder(target, {"summary.json"});
    text_file(folder.path() / "summary.json", "took long");
    fs::create_directory(target);
    text_file(target / "summary.json", "precious");
    expect_error([&] { folder.commit(); }, {"'summary.json' is", "/prosup-result-"});
    EXPECT_EQ(contents(target / "summary.json"), "precious");
    EXPECT_EQ(
        contents(target / (is_there ? "prosup-result-2" : "prosup-result-1") / "summary.json"),
        "took long");
    fs::remove(target / "summary.json");
  }
}

} // namespace
} // namespace prosup::tests
