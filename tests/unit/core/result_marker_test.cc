#include "prosup/core/result_marker.h"

#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

namespace fs = std::filesystem;

TEST(ResultMarker, ListsFilesAndKnowsThemAgain) {
  const TemporaryFolder here;
  fs::create_directory(here / "logs");
  text_file(here / "summary.json", "{}");
  text_file(here / "logs/ü \"1\".out", "");
  ResultMarker::of(here / "").write(here / "");
  const ResultMarker marker = ResultMarker::read(here / "").value();
  EXPECT_TRUE(marker.complete);
  EXPECT_EQ(marker.names(), (std::vector<std::string>{"logs/ü \"1\".out", "summary.json"}));
  EXPECT_TRUE(marker.owns(here / "", "summary.json"));
  EXPECT_TRUE(marker.owns(here / "", "logs/ü \"1\".out"));
  text_file(here / "summary.json", "[]");
  EXPECT_FALSE(marker.owns(here / "", "summary.json"));
  EXPECT_FALSE(marker.owns(here / "", "notes.txt"));
}

// CRC-32 of "123456789" is the check value of its definition.
TEST(ResultMarker, DigestIsSizeAndChecksum) {
  const TemporaryFolder here;
  const FileDigest digest = digest_of(text_file(here / "file", "123456789"));
  EXPECT_EQ(digest.size, 9u);
  EXPECT_EQ(digest.crc32, 0xCBF43926u);
}

std::string with_file(const std::string& file) {
  return R"({"layout": 1, "complete": true, "files": [)" + file + "]}";
}

// A marker that is wrong lists nothing, so that nothing is removed.
TEST(ResultMarker, RefusesWhatIsNoMarkerOrLeadsOutside) {
  ASSERT_TRUE(ResultMarker::parse(with_file("")));
  ASSERT_TRUE(ResultMarker::parse(with_file(R"({"name": "a/b", "size": 1, "crc32": 4294967295})")));
  for (const char* text :
       {"", "{", "[]", "1", "null", R"({"layout": 2, "complete": true, "files": []})",
        R"({"layout": 1, "complete": 1, "files": []})",
        R"({"layout": 1, "complete": true, "files": {}})", "\xff\xfe"})
    EXPECT_FALSE(ResultMarker::parse(text)) << text;
  for (const char* name :
       {"/etc/passwd", "../notes", "a/../../notes", "", ".", "a/", "a/./b", "a\\u0000b"})
    EXPECT_FALSE(ResultMarker::parse(
        with_file(std::string(R"({"name": ")") + name + R"(", "size": 1, "crc32": 1})")))
        << name;
  for (const char* file : {"1", R"({"name": "a"})", R"({"name": 1, "size": 1, "crc32": 1})",
                           R"({"name": "a", "size": -1, "crc32": 1})",
                           R"({"name": "a", "size": 1, "crc32": 4294967296})",
                           R"({"name": "a", "size": 1.5, "crc32": 1})"})
    EXPECT_FALSE(ResultMarker::parse(with_file(file))) << file;
}

} // namespace
} // namespace prosup::tests
