#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.h"
#include "nrrd_text.h"
#include "prosup/image/image_io.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

class NrrdFiles : public ::testing::Test {
protected:
  std::filesystem::path file(const std::string& name, const std::string& text) {
    return text_file(folder_ / name, text);
  }

  void expect_counting(const ScalarImage& image) {
    ASSERT_EQ(image.grid.size, (std::array<std::size_t, 3>{3, 2, 2}));
    for (std::size_t v = 0; v < 12; ++v)
      EXPECT_EQ(image.values[v], float(v));
  }

  TemporaryFolder folder_;
  const std::string bytes_ = counting_bytes(12);
};

// What ITK 5.2 gets wrong: it takes left-anterior-superior for right-posterior-superior.
TEST_F(NrrdFiles, LieWhereTheirSpaceSays) {
  struct Case {
    const char* space;
    Point<3> origin;
    double first, second;
  };
  for (const Case& c : {Case{"left-posterior-superior", {10., 20., 30.}, 1., 1.},
                        {"right-anterior-superior", {-10., -20., 30.}, -1., -1.},
                        {"left-anterior-superior", {10., -20., 30.}, 1., -1.}}) {
    Remarks remarks;
    const auto image =
        read_image(file("a.nrrd", nrrd_fields(c.space) + "encoding: raw\n\n" + bytes_), remarks);
    ASSERT_EQ(image.grid.size, (std::array<std::size_t, 3>{3, 2, 2}));
    for (unsigned v = 0; v < 12; ++v) { // the order of the voxels may be another one
      const Point<3> x(c.origin[0] + c.first * 2. * (v % 3),
                       c.origin[1] + c.second * 2. * (v / 3 % 2), c.origin[2] + 2. * (v / 6));
      const Point<3> index = image.grid.continuous_index(x);
      EXPECT_EQ(image(std::size_t(std::lround(index[0])), std::size_t(std::lround(index[1])),
                      std::size_t(std::lround(index[2]))),
                float(v))
          << c.space;
    }
    EXPECT_TRUE(remarks.all().empty());
  }
}

TEST_F(NrrdFiles, AreReadInAllEncodings) {
  std::string ascii, hex;
  for (int i = 0; i < 12; ++i) {
    ascii += std::to_string(i) + (i % 3 == 2 ? "\n" : " ");
    hex += std::string("0") + "0123456789ab"[i];
  }
  expect_counting(read_image(file("a.nrrd", nrrd_fields() + "encoding: ascii\n\n" + ascii)));
  expect_counting(read_image(file("b.nrrd", nrrd_fields() + "encoding: hex\n\n" + hex + "\n")));
  expect_counting(
      read_image(file("c.nrrd", nrrd_fields() + "encoding: raw\nbyte skip: 3\n\nabc" + bytes_)));
  expect_counting(
      read_image(file("d.nrrd", nrrd_fields() + "encoding: raw\nline skip: 1\n\nabc\n" + bytes_)));
  const auto packed = file("e.nrrd", nrrd_fields() + "encoding: bzip2\n\nBZh9");
  expect_error([&] { read_image(packed); }, {"e.nrrd", "bzip2", "gzip"});
  const auto other = file("f.nrrd", nrrd_fields() + "encoding: zstd\n\nxxx");
  expect_error([&] { read_image(other); }, {"f.nrrd", "zstd"});
}

TEST_F(NrrdFiles, MayHaveAFourthAxisOfOneVolume) {
  const auto fields = [&](const char* sizes, const char* directions, const char* kinds) {
    std::string header = nrrd_fields();
    header.replace(header.find("dimension: 3"), 12, "dimension: 4");
    header.replace(header.find("3 2 2"), 5, sizes);
    header.replace(header.find("(2,0,0) (0,2,0) (0,0,2)"), 23, directions);
    return header + kinds + "encoding: raw\n\n";
  };
  const char *last = "(2,0,0) (0,2,0) (0,0,2) none", *first = "none (2,0,0) (0,2,0) (0,0,2)";
  for (const char* kinds :
       {"", "kinds: domain domain domain domain\n", "kinds: domain domain domain time\n",
        "kinds: space space space list\n", "kinds: domain domain domain vector\n"}) {
    const auto image = read_image(file("a.nrrd", fields("3 2 2 1", last, kinds) + bytes_));
    expect_counting(image);
    EXPECT_EQ(image.grid.origin, Point<3>(10., 20., 30.));
    EXPECT_EQ(image.grid.spacing[2], 2.);
    const auto series = file("b.nrrd", fields("3 2 2 2", last, kinds) + bytes_ + bytes_);
    expect_error([&] { read_image(series); }, {"b.nrrd"});
  }
  for (const char* kinds :
       {"", "kinds: list space space space\n", "kinds: time space space space\n"})
    expect_counting(read_image(file("c.nrrd", fields("1 3 2 2", first, kinds) + bytes_)));
}

TEST_F(NrrdFiles, MayHaveTheirDataApart) {
  std::filesystem::create_directory(folder_ / "data");
  file("data/one file.raw", bytes_);
  file("data/s1.raw", bytes_.substr(0, 6));
  file("data/s2.raw", bytes_.substr(6));
  const std::string raw = nrrd_fields() + "encoding: raw\n";
  expect_counting(read_image(file("a.nhdr", raw + "data file: data/one file.raw\n")));
  expect_counting(read_image(file("b.nhdr", raw + "byte skip: -1\ndata file: " +
                                                (folder_ / "data/one file.raw").string() + "\n")));
  expect_counting(read_image(file("c.nhdr", raw + "data file: LIST\ndata/s1.raw\ndata/s2.raw\n")));
  expect_counting(read_image(file("d.nhdr", raw + "data file: data/s%d.raw 1 2 1\n")));
  for (const std::string bad : {"data file: data/none.raw\n",
                                "data file: LIST\ndata/s1.raw\ns3.raw\n", "data file: data\n"})
    expect_error([&] { read_image(file("e.nhdr", raw + bad)); },
                 {"e.nhdr", "does not exist", "copy it too"});
  expect_error([&] { read_image(file("f.nhdr", raw + "data file: LIST\n")); }, {"f.nhdr", "LIST"});
  expect_error([&] { read_image(file("g.nhdr", raw + "data file: data/s1.raw\n")); },
               {"g.nhdr", "incomplete", "12 bytes", "are 6"});
  expect_error([&] { read_image(file("h.nhdr", raw + "data file: data/t%d.raw 1 2 1\n")); },
               {"h.nhdr", "t1.raw", "does not exist"});
  // A number in a name becomes a format of printf in ITK.
  for (const std::string bad : {"s%999999d.raw 1 2 1", "s%d%s.raw 1 2 1", "s%d.raw 1 2 0",
                                "s%d.raw 2 1 1", "s%d.raw 1 999999999 1"})
    expect_error([&] { read_image(file("i.nhdr", raw + "data file: " + bad + "\n")); },
                 {"i.nhdr", bad});
  file("50% s.raw", bytes_);
  expect_counting(read_image(file("j.nhdr", raw + "data file: 50% s.raw\n")));
}

TEST_F(NrrdFiles, ThatAreTooShortAreRefusedBeforeMemoryIsTaken) {
  for (const std::string encoding : {"raw", "gzip", "ascii", "hex"}) {
    std::string text = nrrd_fields() + "encoding: " + encoding + "\n\n" + bytes_;
    text.replace(text.find("3 2 2"), 5, "300000 200000 20000");
    const auto huge = file("huge.nrrd", text);
    expect_error([&] { read_image(huge); }, {"huge.nrrd", "incomplete", "copy it again"});
  }
}

// What is packed has a checksum, which ITK does not look at.
TEST_F(NrrdFiles, ThatArePackedAreComparedWithTheirChecksum) {
  ScalarImage image;
  image.grid.size = {20, 20, 20};
  image.values.assign(8000, 1.f);
  write_image(image, folder_ / "a.nrrd");
  const std::string whole = contents(folder_ / "a.nrrd");
  EXPECT_NO_THROW(read_image(file("b.nrrd", whole)));
  for (const std::size_t cut : {1, 5, 9})
    expect_error([&] { read_image(file("b.nrrd", whole.substr(0, whole.size() - cut))); },
                 {"b.nrrd", "incomplete"});
  std::string changed = whole;
  changed[changed.size() - 6] ^= 1; // of the checksum
  expect_error([&] { read_image(file("b.nrrd", changed)); }, {"b.nrrd", "incomplete"});
}

TEST_F(NrrdFiles, WithSpacingsOnlyAreDoubtful) {
  Remarks remarks;
  const auto image = read_image(file("a.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 3 2 2\n"
                                               "spacings: 2 2 3\nencoding: raw\n\n" +
                                                   bytes_),
                                remarks);
  expect_counting(image);
  EXPECT_EQ(image.grid.spacing[2], 3.);
  ASSERT_EQ(remarks.all().size(), 1u);
  EXPECT_NE(remarks.all()[0].find("a.nrrd"), std::string::npos);
}

} // namespace
} // namespace prosup::tests
