#include "image/nrrd_header.h"

#include <gtest/gtest.h>

#include <limits>

#include "expect_error.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;
using Vector = std::array<double, 3>;

const std::string lps = "space: left-posterior-superior\n";
const std::string directions = "space directions: (2,0,0) (0,-2,0) (0,0,3)\n";
const std::string origin = "space origin: (1,2,3)\n";

std::string header(const std::string& fields) {
  return "NRRD0005\n# a comment\ntype: short\ndimension: 3\nsizes: 4 5 6\nencoding: raw\n" + fields;
}

NrrdPlace place(const std::string& fields, Remarks& remarks) {
  return nrrd_place(parse_nrrd_header(header(fields), "a.nrrd"), "a.nrrd", remarks).value();
}

TEST(NrrdHeader, FieldsKeysAndLengthAreFound) {
  const std::string text =
      header(lps + "Segment0_Name:=a: b\\nc\\\\d\r\nData File: LIST\nx 1.raw\ny.raw\n");
  const NrrdHeader parsed = parse_nrrd_header(text + "\n\x01\x02", "a.nrrd");
  EXPECT_EQ(parsed.field("space"), "left-posterior-superior");
  EXPECT_EQ(parsed.keys.at("Segment0_Name"), "a: b\nc\\d");
  EXPECT_EQ(parsed.data_files, (std::vector<std::string>{"x 1.raw", "y.raw"}));
  EXPECT_TRUE(parsed.ends);
  EXPECT_EQ(parsed.length, text.size() + 1);
  EXPECT_EQ(parsed.axes.size(), 3u);
  EXPECT_EQ(n_data_bytes(parsed, "a.nrrd"), 240u);
  EXPECT_FALSE(parse_nrrd_header(text, "a.nhdr").ends);
}

TEST(NrrdHeader, AnatomicalSpacesAreTurnedToLps) {
  struct Case {
    std::string space;
    Vector origin, first, second;
  };
  for (const Case& c : {Case{"left-posterior-superior", {1, 2, 3}, {2, 0, 0}, {0, -2, 0}},
                        {"LPS", {1, 2, 3}, {2, 0, 0}, {0, -2, 0}},
                        {"right-anterior-superior", {-1, -2, 3}, {-2, 0, 0}, {0, 2, 0}},
                        {"RAS", {-1, -2, 3}, {-2, 0, 0}, {0, 2, 0}},
                        {"left-anterior-superior", {1, -2, 3}, {2, 0, 0}, {0, 2, 0}},
                        {"LAS-time", {1, -2, 3}, {2, 0, 0}, {0, 2, 0}}}) {
    Remarks remarks;
    const NrrdPlace found = place("space: " + c.space + "\n" + directions + origin, remarks);
    for (unsigned d = 0; d < 3; ++d) {
      EXPECT_EQ(found.origin[d], c.origin[d]) << c.space;
      EXPECT_EQ(found.step[0][d], c.first[d]) << c.space;
      EXPECT_EQ(found.step[1][d], c.second[d]) << c.space;
    }
    EXPECT_TRUE(remarks.all().empty());
  }
}

TEST(NrrdHeader, DoubtIsSpoken) {
  struct Case {
    std::string fields, remark;
    double first_step;
  };
  for (const Case& c :
       {Case{"space: scanner-xyz\n" + directions + origin, "'space: scanner-xyz'", 2.},
        {"space: 3D-left-handed\n" + directions + origin, "'space: 3D-left-handed'", 2.},
        {"space dimension: 3\n" + directions + origin, "no field 'space'", 2.},
        {lps + directions, "no 'space origin'", 2.},
        {lps + directions + origin + "space units: \"um\" \"um\" \"um\"\n", "converted to mm",
         2e-3},
        {lps + directions + origin + "space units: \"m\" \"m\" \"m\" \"s\"\n", "converted", 2e3},
        {lps + directions + origin + "space units: cm\n", "converted to mm", 20.},
        {lps + directions + origin + "space units: \"mm\" \"mm\" \"mm\"\n", "", 2.}}) {
    Remarks remarks;
    EXPECT_DOUBLE_EQ(place(c.fields, remarks).step[0][0], c.first_step) << c.fields;
    ASSERT_EQ(remarks.all().size(), c.remark.empty() ? 0u : 1u) << c.fields;
    if (!c.remark.empty()) {
      EXPECT_NE(remarks.all()[0].find(c.remark), std::string::npos) << remarks.all()[0];
    }
  }
  Remarks remarks;
  const NrrdHeader spaced = parse_nrrd_header(header("spacings: 2 2 3\n"), "a.nrrd");
  EXPECT_FALSE(nrrd_place(spaced, "a.nrrd", remarks));
  EXPECT_EQ(remarks.all().size(), 1u);
}

TEST(NrrdHeader, AxesWithoutDirectionAreNotOfSpace) {
  Remarks remarks;
  const NrrdHeader parsed =
      parse_nrrd_header("NRRD0005\ntype: uint8\ndimension: 4\nsizes: 2 4 5 6\n" + lps + origin +
                            "space directions: none (2, 0, 0)  (0,2,0) (0,0,3)\n",
                        "a.nrrd");
  EXPECT_FALSE(parsed.axes[0].direction);
  EXPECT_EQ(nrrd_place(parsed, "a.nrrd", remarks)->step[2][2], 3.);
}

TEST(NrrdHeader, WhatCannotBeUsedIsRefused) {
  struct Case {
    std::string text;
    std::vector<std::string> message;
  };
  const std::string good = lps + directions + origin;
  for (const Case& c : {
           Case{"", {"NRRD00"}},
           {"NIFTI\n", {"NRRD00"}},
           {"NRRD0005\n", {"'dimension'"}},
           {"NRRD0005\ndimension: 99\nsizes: 1\n", {"'dimension'"}},
           {"NRRD0005\ndimension: 3\nsizes: 4 5\ntype: short\n", {"2 sizes", "dimension of 3"}},
           {"NRRD0005\ndimension: 3\nsizes: 4 -5 6\ntype: short\n", {"'-5'"}},
           {"NRRD0005\ndimension: 3\nsizes: 4 0 6\ntype: short\n", {"'0'"}},
           {"NRRD0005\ndimension: 3\nsizes: 4 5 99999999999999999999\n", {"99999999999999999999"}},
           {"NRRD0005\ndimension: 3\nsizes: 4 5 6\ntype: text\n" + good, {"'text'"}},
           {header("nonsense\n"), {"'nonsense'"}},
           {header("type: short\n"), {"'type' twice"}},
           {header(lps + "space directions: (1,0,0) (0,1,0)\n"), {"2 space directions", "3 axes"}},
           {header(lps + "space directions: (1,0,0) (0,1,0) none\n"), {"2 space directions"}},
           {header(lps + "space directions: (1,0) (0,1,0) (0,0,1)\n"), {"(1,0)", "three numbers"}},
           {header(lps + "space directions: (1,0,nan) (0,1,0) (0,0,1)\n"), {"nan"}},
           {header(lps + "space directions: (1,0,1e300) (0,1,0) (0,0,1)\n"), {"1e300"}},
           {header(lps + "space directions: (0,0,0) (0,1,0) (0,0,1)\n"), {"length 0"}},
           {header(lps + directions + "space origin: (1,2\n"), {"(1,2)"}},
           {header("spacings: 1 2 nan\n"), {"neither 'space directions' nor 'spacings'"}},
           {header(lps + origin), {"neither 'space directions' nor 'spacings'"}},
           {header(good + "space units: \"px\" \"px\" \"px\"\n"), {"space units", "px"}},
           {header(good + "space units: \"mm\" \"mm\" \"um\"\n"), {"space units"}},
       }) {
    Remarks remarks;
    auto parts = c.message;
    parts.emplace_back("'a.nrrd'");
    expect_error(
        [&] {
          const NrrdHeader parsed = parse_nrrd_header(c.text, "a.nrrd");
          n_data_bytes(parsed, "a.nrrd");
          nrrd_place(parsed, "a.nrrd", remarks);
        },
        parts);
  }
}

TEST(NrrdHeader, BytesDoNotOverflow) {
  const NrrdHeader parsed = parse_nrrd_header(
      "NRRD0005\ntype: double\ndimension: 3\nsizes: 4000000000 4000000000 4000000000\n", "a.nrrd");
  EXPECT_EQ(n_data_bytes(parsed, "a.nrrd"), std::numeric_limits<std::uintmax_t>::max());
}

} // namespace
} // namespace prosup::tests
