#include "prosup/core/output_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "prosup/core/error.h"
#include "prosup/core/exception_text.h"
#include "prosup/core/result_folder.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

namespace fs = std::filesystem;

const std::string header = "id,x,y,z";

void write(const fs::path& file, const std::string& text, const OutputFileRules& rules) {
  OutputFile output(file, rules);
  text_file(output.path(), text);
  output.commit();
}

std::size_t n_entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(OutputFile, IsWrittenAsAWholeOrNotAtAll) {
  const TemporaryFolder here;
  const fs::path file = here / "out.csv";
  {
    const OutputFile output(file, {{}, false, header});
    text_file(output.path(), "half");
    EXPECT_FALSE(fs::exists(file));
    EXPECT_THROW(OutputFile(file, {}), Error); // one at a time
  }
  EXPECT_EQ(n_entries(here / ""), 0u);
  for (const char* row : {"\na", "\nb"}) {
    write(file, header + row, {{}, false, header});
    EXPECT_EQ(contents(file), header + row);
  }
  EXPECT_EQ(n_entries(here / ""), 1u);
}

// What fails while a file has its temporary name is told of the file that the user knows.
TEST(TemporaryName, IsNotSpokenOf) {
  const TemporaryFolder here;
  fs::path folder, file;
  {
    const ResultFolder result(here / "out");
    folder = result.path();
    const TemporaryName inner(folder / ".a.part", folder / "a.h5");
    EXPECT_EQ(text_of(Error("'" + (folder / ".a.part").string() + "' and '" +
                            (folder / "b.vtu").string() + "' are full.")),
              "'" + (here / "out/a.h5").string() + "' and '" + (here / "out/b.vtu").string() +
                  "' are full.");
    const OutputFile output(here / "points.csv", {});
    file = output.path();
    EXPECT_EQ(text_of(std::runtime_error("no " + file.string())),
              "no " + (here / "points.csv").string());
  }
  EXPECT_EQ(text_of(Error(file.string())), file.string());
  EXPECT_EQ(text_of(Error(folder.string())), folder.string());
}

TEST(OutputFile, ReplacesOnlyWhatTheCommandWrites) {
  const TemporaryFolder here;
  const fs::path file = text_file(here / "out.csv", "patient,age\n");
  EXPECT_THROW(OutputFile(file, {{}, false, header}), Error);
  EXPECT_EQ(contents(file), "patient,age\n");
  write(file, header + "\n", {{}, true, header});
  EXPECT_EQ(contents(file), header + "\n");
  write(file, header + "\n", {}); // equal
  EXPECT_THROW(write(file, "other", {}), Error);
  EXPECT_EQ(contents(file), header + "\n");
  EXPECT_EQ(n_entries(here / ""), 1u);
}

TEST(OutputFile, IsNoInputAlsoThroughLinks) {
  const TemporaryFolder here;
  const fs::path input = text_file(here / "in.csv", header);
  fs::create_symlink(input, here / "soft.csv");
  fs::create_hard_link(input, here / "hard.csv");
  for (const char* name : {"in.csv", "soft.csv", "hard.csv"})
    for (const bool overwrite : {false, true})
      EXPECT_THROW(OutputFile(here / name, {{"", input}, overwrite, header}), Error) << name;
  EXPECT_EQ(contents(input), header);
}

TEST(OutputFile, FollowsALinkAndKeepsModes) {
  const TemporaryFolder here;
  const fs::path file = text_file(here / "real.csv", header);
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.csv", here / "link.csv");
  write(here / "link.csv", header + "\n", {{}, false, header});
  EXPECT_TRUE(fs::is_symlink(here / "link.csv"));
  EXPECT_EQ(contents(file), header + "\n");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

// As /dev/stdout is where another program reads it.
TEST(OutputFile, MayBeAPipeThatALinkLeadsTo) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  write("/proc/self/fd/" + std::to_string(ends[1]), "text", {{}, false, header});
  std::string read_back(4, '\0');
  EXPECT_EQ(read(ends[0], read_back.data(), 4), 4);
  EXPECT_EQ(read_back, "text");
  close(ends[0]);
  close(ends[1]);
}

TEST(OutputFile, MayBeADeviceButNoFolder) {
  const TemporaryFolder here;
  write("/dev/null", "text", {{}, false, header});
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
  EXPECT_THROW(OutputFile(here / "", {}), Error);
  EXPECT_THROW(OutputFile(here / "no/such/folder.csv", {}), Error);
}

} // namespace
} // namespace prosup::tests
