#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/evaluation/landmarks.h"
#include "prosup/evaluation/points.h"

namespace prosup::tests {
namespace {

using namespace prosup::evaluation;

struct Dialect {
  std::string text;
  std::string remark; ///< part of the only remark; none if empty
  PointFormat format = PointFormat::csv;
};

class Dialects : public ::testing::TestWithParam<Dialect> {};

/// All of the files hold these two points.
TEST_P(Dialects, AreUnderstood) {
  Remarks remarks;
  const auto points = parse_points(GetParam().text, GetParam().format, "some.csv", remarks);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].id, "a");
  EXPECT_EQ(points[0].position, Point<3>(1.5, -2., 3.));
  EXPECT_EQ(points[1].id, "b, \"left\"");
  EXPECT_EQ(points[1].position, Point<3>(4., 5., -6.));
  ASSERT_EQ(remarks.all().size(), GetParam().remark.empty() ? 0u : 1u);
  if (!GetParam().remark.empty()) {
    EXPECT_NE(remarks.all()[0].find(GetParam().remark), std::string::npos) << remarks.all()[0];
  }
}

const std::string rows = "a,1.5,-2,3\n\"b, \"\"left\"\"\",4,5,-6\n";
const std::string turned = "a,-1.5,2,3\n\"b, \"\"left\"\"\",-4,-5,-6\n";

INSTANTIATE_TEST_SUITE_P(
    Csv, Dialects,
    ::testing::Values(
        Dialect{"id,x,y,z\n" + rows, ""}, Dialect{"\xEF\xBB\xBFid,x,y,z\n" + rows, ""},
        Dialect{"ID, X ,Y,\"Z\"\r\na, 1.5 ,-2,+3\r\n\r\n\"b, \"\"left\"\"\",4e0,5.,-6\r\n", ""},
        Dialect{"sep=,\nid,x,y,z\n" + rows, ""}, Dialect{"id,x_mm,Y [mm],z(mm)\n" + rows, ""},
        Dialect{"# second reading, \"odd\n#x\nid,x,y,z\n# first\n" + rows, ""},
        Dialect{"id,x,y,z,,\na,1.5,-2,3,,\n\"b, \"\"left\"\"\",4,5,-6,,\n,,,,,\n", ""},
        Dialect{"id,x,y,z\na,1.5,-2,3,\n\"b, \"\"left\"\"\",4,5,-6,,,\n", ""},
        Dialect{"note,z,id,y,x\n,3,a,-2,1.5\n\"two\nlines\",-6,\"b, \"\"left\"\"\",5,4\n", ""},
        Dialect{"name,x,y,z\n" + rows, ""}, Dialect{"Label,L,P,S\n" + rows, ""},
        Dialect{"label,r,a,s\n" + turned, "r, a and s"}, Dialect{"id,R,A,S\n" + turned, "RAS"},
        Dialect{"# CoordinateSystem = RAS\nid,x,y,z\n" + turned, "x, y and z"}));

TEST(PointRemarks, TellWhatWasLeftOutOrGuessed) {
  Remarks remarks;
  const auto parse = [&](const std::string& text) {
    return parse_points(text, PointFormat::csv, "p.csv", remarks);
  };
  EXPECT_EQ(parse("id,x,y,z,defined\na,1,2,3,1\nb,0,0,0,0\n").size(), 1u);
  EXPECT_NE(remarks.all().back().find("1 points are named but not placed"), std::string::npos);
  EXPECT_EQ(parse("id,x,y,z\na,1,2,3\na,0,0,0\nc,1,1,1\n").size(), 3u);
  EXPECT_NE(remarks.all().back().find("1 of 3 points"), std::string::npos);
  EXPECT_EQ(parse("id,x,y,z\nL\xE4sion,1,2,3\n")[0].id, "L\xC3\xA4sion");
  EXPECT_NE(remarks.all().back().find("Latin-1"), std::string::npos);
  EXPECT_EQ(remarks.all().size(), 3u);
}

// A '#' does not make a comment of a row that has all its values.
TEST(PointIds, MayBeginWithANumberSign) {
  Remarks remarks;
  const auto points = parse_points("id,x,y,z\n#1,1,2,3\n", PointFormat::csv, "p.csv", remarks);
  EXPECT_EQ(points.at(0).id, "#1");
}

TEST(LandmarkDialects, AreThoseOfPoints) {
  Remarks remarks;
  const auto landmarks =
      parse_landmarks("Name,Prone_R,prone_a,prone_s,supine_x [mm],supine_y_mm,supine_z,tre_mm,tre\n"
                      "1,-1,-2,3,4,5,6,0,0\n",
                      "l.csv", remarks);
  ASSERT_EQ(landmarks.size(), 1u);
  EXPECT_EQ(landmarks[0].prone, Point<3>(1., 2., 3.));
  EXPECT_EQ(landmarks[0].supine, Point<3>(4., 5., 6.));
  ASSERT_EQ(remarks.all().size(), 1u);
  EXPECT_NE(remarks.all()[0].find("prone_r, prone_a and prone_s"), std::string::npos);
}

struct BadText {
  std::string text;
  std::vector<std::string> message;
  PointFormat format = PointFormat::csv;
};

class BadPointText : public ::testing::TestWithParam<BadText> {};

TEST_P(BadPointText, IsRefusedWithTheReason) {
  auto parts = GetParam().message;
  parts.emplace_back("some.csv");
  Remarks remarks;
  expect_error([&] { parse_points(GetParam().text, GetParam().format, "some.csv", remarks); },
               parts);
}

std::string wide(const std::string& text) {
  std::string result = "\xFF\xFE";
  for (const char c : text)
    result += std::string(1, c) + '\0';
  return result;
}

INSTANTIATE_TEST_SUITE_P(
    Csv, BadPointText,
    ::testing::Values(
        BadText{"id;x;y;z\na;1,5;2,0;3,0\n", {"line 1", "semicolons", "commas"}},
        BadText{"sep=;\nid;x;y;z\na;1;2;3\n", {"semicolons"}},
        BadText{"id;x, left;y;z\na;1;2;3\n", {"semicolons"}},
        BadText{"id\tx\ty\tz\na\t1\t2\t3\n", {"tabs"}},
        BadText{"sep=\t\nid\tx\ty\tz\na\t1\t2\t3\n", {"tabs"}},
        BadText{"id|x|y|z\na|1|2|3\n", {"vertical bars"}},
        BadText{"id,x,y,z\na,1,5,2,0,3,0\n", {"line 2", "7 values", "4 columns", "decimals"}},
        BadText{"id,x,y,z\na,\"1,5\",2,3\n", {"line 2", "column 'x'", "'1,5'", "decimal point"}},
        BadText{"id,x,y,z\na,\"1,234.5\",2,3\n", {"'1,234.5'"}},
        BadText{wide("id,x,y,z\na,1,2,3\n"), {"UTF-16", "UTF-8"}},
        BadText{wide("id,x,y,z\na,1,2,3\n").substr(2), {"UTF-16 or no text"}},
        BadText{"id,x,y,z\ra,1,2,3\r", {"carriage returns"}},
        BadText{"a,1,2,3\nb,4,5,6\n", {"line 1", "header line", "id,x,y,z"}},
        BadText{"1,1,2,3\n", {"header line"}},
        BadText{"id,x,y,z\na,=B2,2,3\n", {"line 2", "'=B2'"}},
        BadText{"id,x,y,z\na,,2,3\n", {"column 'x'", "''"}},
        BadText{"id,x,y,z\na,NaN,2,3\n", {"'NaN'"}}, BadText{"id,x,y,z\na,1 mm,2,3\n", {"'1 mm'"}},
        BadText{"id,x,y,z\na,0x10,2,3\n", {"'0x10'"}},
        BadText{"id,x,y,z\na,1e300,2,3\n", {"column 'x'", "1e+300", "no position"}},
        BadText{"id,x,y,z\na,1e999,2,3\n", {"'1e999'"}},
        BadText{"id,x[cm],y[cm],z[cm]\na,1,2,3\n", {"'x[cm]'", "'cm'", "convert"}},
        BadText{"id,x_m,y_m,z_m\na,1,2,3\n", {"'x_m'", "'m'"}},
        BadText{"id,x,y,z [\xC2\xB5m]\na,1,2,3\n", {"convert"}},
        BadText{"id,x,y,z,X\na,1,2,3,4\n", {"'x' occurs twice"}},
        BadText{"id,x,y,z,r,a,s\na,1,2,3,-1,-2,3\n", {"several triples"}},
        BadText{"id,i,j,k\na,1,2,3\n", {"no column 'x'", "id, i, j, k"}},
        BadText{"# CoordinateSystem = IJK\nid,x,y,z\na,1,2,3\n", {"'IJK'", "LPS or RAS"}},
        BadText{"id,x,y,z\n\"a,1,2,3\nb,1,2,3\n", {"line 2", "quotation mark"}},
        BadText{"\"a\nb\",x\n1\n", {"line 3", "(a b, x)"}},
        BadText{"x,y,z\n1,2,3\n", {"no column 'id'"}}, BadText{"", {"no points"}},
        BadText{"\xEF\xBB\xBF", {"no points"}}, BadText{"# only\n\n,,,\n", {"no points"}},
        BadText{"label,r,a,s,defined\na,0,0,0,0\n", {"no points"}}));

} // namespace
} // namespace prosup::tests
