// MetaImage files as programs leave them.

#include <gtest/gtest.h>
#include <zlib.h>

#include <numeric>
#include <random>

#include "expect_error.h"
#include "image/meta_files.h"
#include "nifti_bytes.h"
#include "prosup/image/image_io.h"
#include "temporary_folder.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

const std::string place = "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 10 20 30\n"
                          "ElementSpacing = 1.5 2 3\n";
const std::string usual = "ObjectType = Image\nNDims = 3\nDimSize = 4 3 2\n" + place;

class MetaImage : public ::testing::Test {
protected:
  /// The bytes 0 to 23, or as many.
  static std::string bytes(std::size_t n = 24) {
    std::string bytes(n, '\0');
    std::iota(bytes.begin(), bytes.end(), '\0');
    return bytes;
  }
  static std::vector<float> numbers() {
    std::vector<float> values(24);
    std::iota(values.begin(), values.end(), 0.f);
    return values;
  }
  static std::string packed(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    compress(reinterpret_cast<Bytef*>(result.data()), &size,
             reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    result.resize(size);
    return result;
  }

  ScalarImage read(const std::string& header, const std::string& behind = "") {
    write_bytes(header + behind, file_);
    remarks_ = Remarks();
    return read_image(file_, remarks_);
  }
  /// Reads an image of bytes whose voxels follow the header.
  ScalarImage read_local(const std::string& header) {
    return read(header + "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n", bytes());
  }
  void expect_remark(const std::string& fragment) const {
    ASSERT_EQ(remarks_.all().size(), 1u) << fragment;
    EXPECT_NE(remarks_.all().front().find(fragment), std::string::npos) << remarks_.all().front();
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "image.mhd";
  Remarks remarks_;
};

TEST_F(MetaImage, TakesTheNameOfItsDataAsItIs) {
  for (const char* name : {"a 77 %.raw", "%d%s%n.raw", "50%d 1 2", "#ä 'x'.raw", "slice%03d.raw"}) {
    write_bytes(bytes(), folder_ / name);
    const auto image = read(usual + "ElementType = MET_UCHAR\nElementDataFile = " + name + "\r\n");
    EXPECT_EQ(image.values, numbers()) << name;
    EXPECT_TRUE(remarks_.all().empty());
  }
  expect_error([&] { read(usual + "ElementType = MET_UCHAR\nElementDataFile = no 5 %.raw\n"); },
               {"image.mhd", "no 5 %.raw", "does not exist"});
}

TEST_F(MetaImage, ReadsSlicesByPatternAndByList) {
  for (const int slice : {1, 2})
    write_bytes(bytes().substr(12 * std::size_t(slice - 1), 12),
                folder_ / ("s00" + std::to_string(slice) + ".raw"));
  const std::string header = usual + "ElementType = MET_UCHAR\nElementDataFile = ";
  EXPECT_EQ(read(header + "s%03d.raw 1 2 1\n").values, numbers());
  EXPECT_EQ(read(header + "s%03d.raw 1 2\n").values, numbers());
  EXPECT_EQ(read(header + "LIST\ns001.raw\r\ns002.raw\r\n").values, numbers());
  expect_error([&] { read(header + "LIST\ns001.raw\n"); }, {"1 files", "2 slices"});
  expect_error([&] { read(header + "s%03d.raw 1 3 1\n"); }, {"3 files", "2 slices"});
  expect_error([&] { read(header + "s%03d.raw 2 3 1\n"); }, {"s003.raw", "does not exist"});
  for (const char* text : {"s%n.raw 1 2", "s%s 1 2", "s%d%d 1 2", "s%d 1", "s%999d 1 2", "s 1 2",
                           "s%d 1 2 0", "s%d 1 999999999", "%", ""})
    EXPECT_TRUE(names_of_pattern(text).empty()) << text;
  EXPECT_EQ(names_of_pattern("a%2d.x 9 11 2"), (std::vector<std::string>{"a 9.x", "a11.x"}));
}

TEST_F(MetaImage, UnpacksWithAndWithoutTheSize) {
  const std::string data = packed(bytes());
  write_bytes(data, folder_ / "image.zraw");
  const std::string header = usual + "CompressedData = True\nElementType = MET_UCHAR\n";
  const std::string size = "CompressedDataSize = " + std::to_string(data.size()) + "\n";
  const std::string apart = "ElementDataFile = image.zraw\n", local = "ElementDataFile = LOCAL\n";
  EXPECT_EQ(read(header + apart).values, numbers());
  EXPECT_EQ(read(header + size + apart).values, numbers());
  EXPECT_EQ(read(header + local, data).values, numbers());
  EXPECT_EQ(read(header + size + "HeaderSize = -1\n" + local, data).values, numbers());
  expect_error([&] { read(header + "HeaderSize = -1\n" + local, data); }, {"CompressedDataSize"});
  expect_error([&] { read(header + local, data.substr(0, data.size() - 2)); },
               {"image.mhd", "damaged or incomplete"});
  expect_error([&] { read(header + local, bytes()); }, {"image.mhd", "damaged or incomplete"});
}

TEST_F(MetaImage, FindsTheVoxelsInTheirFile) {
  write_bytes("head" + bytes(), folder_ / "image.raw");
  const std::string data = "ElementType = MET_UCHAR\nElementDataFile = image.raw\n";
  EXPECT_EQ(read(usual + "HeaderSize = 4\n" + data).values, numbers());
  EXPECT_EQ(read(usual + "HeaderSize = -1\n" + data).values, numbers());
  EXPECT_TRUE(remarks_.all().empty());
  EXPECT_EQ(read(usual + data).values[4], 0.f);
  expect_remark("goes on behind");
  expect_error([&] { read(usual + "HeaderSize = 5\n" + data); }, {"damaged or incomplete"});
  expect_error([&] { read(usual + "HeaderSize = -2\n" + data); }, {"HeaderSize"});
}

TEST_F(MetaImage, ReadsTextAndOtherByteOrders) {
  EXPECT_EQ(read(usual + "BinaryData = False\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n",
                 "0 1 2 3\n4 5 6 7 8 9 10 11 12 13\t14 15 16 17 18 19 20 21 22 2.3e1\n")
                .values,
            numbers());
  expect_error(
      [&] {
        read(usual + "BinaryData = False\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n",
             "0 1 2 3\n4 5 x 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30");
      },
      {"image.mhd", "number 7"});
  std::string large(48, '\0');
  for (std::size_t v = 0; v < 24; ++v)
    large[2 * v + 1] = static_cast<char>(v);
  for (const char* key : {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"})
    EXPECT_EQ(
        read(usual + key + " = True\nElementType = MET_SHORT\nElementDataFile = LOCAL\n", large)
            .values,
        numbers());
}

TEST_F(MetaImage, HasOnePlace) {
  const std::string begin = "NDims = 3\nDimSize = 4 3 2\n";
  for (const char* axes : {"TransformMatrix", "Rotation", "Orientation"})
    for (const char* origin : {"Offset", "Position", "Origin"})
      for (const char* spacing : {"ElementSpacing", "ElementSize"}) {
        const VoxelGrid grid = read_local(begin + axes + " = 0 1 0 -1 0 0 0 0 1\n" + origin +
                                          " : 10 20 +30\n" + spacing + " = 1.5 2 3\n")
                                   .grid;
        EXPECT_TRUE(remarks_.all().empty());
        // The first axis points to posterior; it is the second one in the usual order.
        EXPECT_EQ(grid.size, (std::array<std::size_t, 3>{3, 4, 2}));
        EXPECT_EQ(grid.spacing[1], 1.5);
      }
  read_local(begin + "ElementSpacing = 1.5 2 3\nElementSize = 9 9 9\nOffset = 1 2 3\n"
                     "TransformMatrix = 1 0 0 0 1 0 0 0 1\n");
  EXPECT_TRUE(remarks_.all().empty());
  read_local(begin);
  expect_remark("no ElementSpacing (1 mm was assumed), no Offset");
  expect_error([&] { read_local(usual + "Origin = 10 20 31\n"); }, {"Offset", "Origin"});
  read_local(begin + "Offset = 1 2 3\nElementSpacing = 1 1 1\nAnatomicalOrientation = ASL\n"
                     "TransformMatrix = 1 0 0 0 1 0 0 0 1\n");
  EXPECT_TRUE(remarks_.all().empty());
  read_local("NDims = 3\nDimSize = 4 3 2\nOffset = 1 2 3\nElementSpacing = 1 1 1\n"
             "TransformMatrix = 0 1 0 -1 0 0 0 0 1\nCenterOfRotation = 5 0 0\n");
  expect_remark("CenterOfRotation");
}

TEST_F(MetaImage, UsesItsUnitAndScale) {
  const auto grid = read_local(usual + "DistanceUnits = cm\n").grid;
  expect_remark("in cm");
  EXPECT_EQ(grid.spacing[0], 15.);
  EXPECT_EQ(grid.origin[2], 300.);
  EXPECT_EQ(read_local(usual + "ElementToIntensityFunctionSlope = 2\n"
                               "ElementToIntensityFunctionOffset = -1\n")
                .values[3],
            5.f);
  expect_remark("slope 2");
}

TEST_F(MetaImage, IsRefusedIfItsHeaderMakesNoSense) {
  const auto refused = [&](const std::string& header, const std::vector<std::string>& fragments) {
    expect_error([&] { read_local(header); }, fragments);
  };
  refused("NDims = 3\nDimSize = 4 3\n" + place, {"image.mhd", "2 numbers in DimSize", "3"});
  refused("NDims = 3\nDimSize = 4 3 x\n" + place, {"'x' in DimSize"});
  refused("NDims = 3\nDimSize = 4 -3 2\n" + place, {"-3", "DimSize"});
  refused("NDims = 3\nDimSize = 4 3 2.5\n" + place, {"2.5", "DimSize"});
  refused("NDims = 3\n" + place, {"no DimSize"});
  refused("NDims = 300\nDimSize = 1\n", {"NDims"});
  refused("NDims = 3\nDimSize = 4000000 3000000 2000000\n" + place, {"4000000 x 3000000"});
  refused("NDims = 3\nDimSize = 1000 1000 1000\n" + place, {"damaged or incomplete"});
  refused(usual + "ElementSpacing = 1 1\n", {"2 numbers in ElementSpacing"});
  refused(usual + "ElementSpacing = nan 1 1\n", {"'nan'"});
  refused(usual + "TransformMatrix = 2 0 0 0 2 0 0 0 2\n", {"length 1"});
  refused(usual + "TransformMatrix = 1 0 0 1 0 0 0 0 1\n", {"right angles"});
  refused(usual + "ObjectType = Mesh\n", {"Mesh"});
  refused(usual + "DistanceUnits = inch\n", {"inch"});
  refused(usual + "ElementNumberOfChannels = 3\n", {"3 values per voxel"});
  refused(usual + "this is no header\n", {"this is no header"});
  refused(usual + "CompressedData = maybe\n", {"maybe"});
  expect_error([&] { read(usual + "ElementType = MET_OTHER\nElementDataFile = LOCAL\n"); },
               {"MET_OTHER"});
  expect_error([&] { read(usual + "ElementDataFile = LOCAL\n"); }, {"no ElementType"});
}

TEST_F(MetaImage, IsReadOrRefusedWhateverItsHeaderHolds) {
  std::mt19937 random(5);
  const std::string good =
      usual + "HeaderSize = 0\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
  unsigned n_read = 0;
  for (unsigned i = 0; i < 10000; ++i) {
    std::string text = good;
    for (unsigned change = 0; change < 1 + i % 3; ++change)
      text[random() % text.size()] = static_cast<char>(random() % 128);
    Remarks untold;
    try {
      parse_meta_header(text, "image.mhd", untold);
      ++n_read;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(n_read, 100u);
  EXPECT_LT(n_read, 9900u);
}

} // namespace
} // namespace prosup::tests
