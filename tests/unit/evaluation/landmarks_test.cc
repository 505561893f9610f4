#include "prosup/evaluation/landmarks.h"

#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/evaluation/landmarks_csv.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::evaluation;

const std::string header = "id,prone_x,prone_y,prone_z,supine_x,supine_y,supine_z";

TEST(Landmarks, AreReadWithUnloadedPosition) {
  const TemporaryFolder folder;
  const auto landmarks =
      read_landmarks(text_file(folder / "l.csv", header + ",unloaded_x,unloaded_y,unloaded_z\n"
                                                          "7,1,2,3,4,5,6,-7,-8e0,-9.5\n"));
  ASSERT_EQ(landmarks.size(), 1u);
  EXPECT_EQ(landmarks[0].id, "7");
  EXPECT_EQ(landmarks[0].prone, Point<3>(1., 2., 3.));
  EXPECT_EQ(landmarks[0].supine, Point<3>(4., 5., 6.));
  EXPECT_EQ(landmarks[0].unloaded.value(), Point<3>(-7., -8., -9.5));
}

TEST(Landmarks, AreReadAsTheyWereWritten) {
  const TemporaryFolder folder;
  std::vector<Landmark> landmarks{{"a,b", {1., 2., 3.}, {-4., 5.25, 6.}, Point<3>(7., 8., -9.125)},
                                  {"c", {1., 1., 1.}, {2., 2., 2.}, Point<3>(3., 3., 3.)}};
  write_landmarks(landmarks, folder / "l.csv");
  const auto read = read_landmarks(folder / "l.csv");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].id, "a,b");
  EXPECT_EQ(read[0].prone, landmarks[0].prone);
  EXPECT_EQ(read[0].supine, landmarks[0].supine);
  EXPECT_EQ(read[0].unloaded, landmarks[0].unloaded);
  landmarks[1].unloaded.reset();
  write_landmarks(landmarks, folder / "l.csv");
  EXPECT_FALSE(read_landmarks(folder / "l.csv")[0].unloaded);
}

// A spreadsheet's file: byte order mark, carriage returns, spaces, another order
// of columns, an extra column, blank lines.
TEST(Landmarks, OrderAndTypographyAreFree) {
  const TemporaryFolder folder;
  const auto landmarks = read_landmarks(
      text_file(folder / "l.csv",
                "\xEF\xBB\xBFsupine_x,supine_y,supine_z, note ,prone_z,prone_y,prone_x,id\r\n\r\n"
                "4,5,6,\"nipple, left\",3,2,+1, N \r\n"));
  ASSERT_EQ(landmarks.size(), 1u);
  EXPECT_EQ(landmarks[0].id, "N");
  EXPECT_EQ(landmarks[0].prone, Point<3>(1., 2., 3.));
  EXPECT_EQ(landmarks[0].supine, Point<3>(4., 5., 6.));
  EXPECT_FALSE(landmarks[0].unloaded);
}

struct BadFile {
  std::string text;
  std::vector<std::string> message;
};

class BadLandmarks : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadLandmarks, AreRefusedWithFileAndLine) {
  const TemporaryFolder folder;
  const auto file = text_file(folder / "l.csv", GetParam().text);
  auto parts = GetParam().message;
  parts.push_back("l.csv");
  expect_error([&] { read_landmarks(file); }, parts);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadLandmarks,
    ::testing::Values(
        BadFile{"", {"no points"}}, BadFile{header + "\n", {"no points"}},
        BadFile{"id,prone_x,prone_y,prone_z,supine_x,supine_y\na,1,2,3,4,5\n",
                {"no column 'supine_z'", "id, prone_x"}},
        BadFile{header + ",prone_x\na,1,2,3,4,5,6,7\n", {"line 1", "'prone_x' occurs twice"}},
        BadFile{header + ",unloaded_x\na,1,2,3,4,5,6,7\n", {"no column 'unloaded_y'"}},
        BadFile{header + "\na,1,2,3,4,5,6\n\nb,1,2,3,4,5\n", {"line 4", "6 values", "7 columns"}},
        BadFile{header + "\na,1,2,3,4,5,6,7\n", {"line 2", "8 values"}},
        BadFile{header + "\na,1,2,3mm,4,5,6\n", {"line 2", "'3mm'", "finite number in mm"}},
        BadFile{header + "\na,1,,3,4,5,6\n", {"line 2", "''"}},
        BadFile{header + "\na,1,nan,3,4,5,6\n", {"line 2", "'nan'"}},
        BadFile{header + "\na,1,2,3,4,inf,6\n", {"line 2", "'inf'"}},
        BadFile{header + "\na,1,2,3,4,+-5,6\n", {"line 2", "'+-5'"}},
        BadFile{header + "\na,1,2,3,4,5,6\na,1,2,3,4,5,6\n", {"line 3", "'a' is used twice"}},
        BadFile{header + "\n,1,2,3,4,5,6\n", {"line 2", "empty"}}));

TEST(Landmarks, MissingFileIsNamed) {
  expect_error([] { read_landmarks("no/such/landmarks.csv"); },
               {"no/such/landmarks.csv", "cannot be read"});
}

} // namespace
} // namespace prosup::tests
