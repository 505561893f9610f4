// What the voxels of NIfTI files hold, and the files around them.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "expect_error.h"
#include "image/nifti_header.h"
#include "nifti_bytes.h"
#include "prosup/image/image_io.h"
#include "temporary_folder.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;
using field = nifti_field;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

class NiftiValues : public ::testing::Test {
protected:
  std::vector<float> read(const NiftiBytes& bytes) {
    write_bytes(bytes.all(), file_);
    return read(file_);
  }
  std::vector<float> read(const std::filesystem::path& file) {
    remarks_ = Remarks();
    return read_image(file, remarks_).values;
  }

  std::string remark() const { return remarks_.all().empty() ? "" : remarks_.all().front(); }
  void expect_remark(const std::string& fragment) const {
    EXPECT_NE(remark().find(fragment), std::string::npos) << remark();
  }

  static std::vector<float> numbers(std::size_t n = 24) {
    std::vector<float> values(n);
    std::iota(values.begin(), values.end(), 0.f);
    return values;
  }

  template <typename Number>
  void expect_type(int datatype) {
    std::vector<Number> stored(24);
    std::iota(stored.begin(), stored.end(), Number());
    stored[22] = std::numeric_limits<Number>::lowest();
    stored[23] = std::numeric_limits<Number>::max();
    std::vector<float> expected(stored.begin(), stored.end());
    for (const bool swapped : {false, true}) {
      if (std::is_same_v<Number, double>) // see BeyondFloatAreErrors
        stored[22] = stored[23] = Number(1), expected[22] = expected[23] = 1.f;
      EXPECT_EQ(read(NiftiBytes(swapped).voxels(datatype, stored)), expected) << datatype;
      EXPECT_EQ(remark(), "");
    }
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "image.nii";
  Remarks remarks_;
};

TEST_F(NiftiValues, AreOfAnyRealType) {
  expect_type<std::uint8_t>(2);
  expect_type<std::int8_t>(256);
  expect_type<std::int16_t>(4);
  expect_type<std::uint16_t>(512);
  expect_type<std::int32_t>(8);
  expect_type<std::uint32_t>(768);
  expect_type<std::int64_t>(1024);
  expect_type<std::uint64_t>(1280);
  expect_type<float>(16);
  expect_type<double>(64);
}

TEST_F(NiftiValues, OfOtherTypesAreRefused) {
  struct Case {
    int type, bits;
    const char* fragment;
  };
  for (const Case& c : {Case{128, 24, "3 values per voxel"},
                        {2304, 32, "4 values per voxel"},
                        {32, 64, "2 values per voxel"},
                        {1536, 128, "128 bits"},
                        {1, 1, "bits"},
                        {0, 0, "data type 0"},
                        {-7, 16, "data type -7"}}) {
    auto bytes = NiftiBytes().put<std::int16_t>(field::datatype,
                                                {std::int16_t(c.type), std::int16_t(c.bits)});
    bytes.behind_voxels(std::string(400, '\0'));
    expect_error([&] { read(bytes); }, {"image.nii", c.fragment});
  }
  EXPECT_EQ(read(NiftiBytes().put<std::int16_t>(field::bitpix, {8})), numbers());
  expect_remark("8 bits");
}

TEST_F(NiftiValues, AreScaled) {
  auto expected = numbers();
  for (float& value : expected)
    value = 0.5f * value - 1024.f;
  EXPECT_EQ(read(NiftiBytes().put<float>(field::scl_slope, {0.5f, -1024.f})), expected);
  EXPECT_EQ(remark(), "");
}

TEST_F(NiftiValues, AreAsStoredWhereTheScaleIsNone) {
  EXPECT_EQ(read(NiftiBytes().put<float>(field::scl_slope, {nan, nan})), numbers());
  EXPECT_EQ(remark(), "");
  EXPECT_EQ(read(NiftiBytes().put<float>(field::scl_slope, {0.f, 0.f})), numbers());
  EXPECT_EQ(remark(), "");
  EXPECT_EQ(read(NiftiBytes().put<float>(field::scl_slope, {0.f, 7.f})), numbers());
  expect_remark("intercept 7");
  EXPECT_EQ(read(NiftiBytes().put<float>(field::scl_slope, {1.f, nan})), numbers());
  expect_remark("taken as 0");
  const auto endless = NiftiBytes().put<float>(field::scl_slope, {infinity, 0.f});
  expect_error([&] { read(endless); }, {"image.nii", "slope"});
}

TEST_F(NiftiValues, ThatAreNotFiniteAreErrors) {
  for (const float bad : {nan, infinity, -infinity}) {
    auto values = numbers();
    values[6] = values[8] = bad; // (2, 1, 0) is the first
    const auto bytes = NiftiBytes().voxels(16, values);
    expect_error([&] { read(bytes); }, {"image.nii", "2 voxels", "(-13.0, -22.0, 30.0)"});
  }
}

TEST_F(NiftiValues, BeyondFloatAreErrors) {
  std::vector<double> values(24, 1.);
  values[3] = -1e300;
  expect_error([&] { read(NiftiBytes().voxels(64, values)); }, {"image.nii", "1 voxel"});
  const auto steep = NiftiBytes().put<float>(field::scl_slope, {3e38f, 0.f});
  expect_error([&] { read(steep); }, {"image.nii", "finite"});
}

TEST_F(NiftiValues, AreThoseOfOneVolume) {
  const auto dims = [](std::initializer_list<std::int16_t> dim) {
    return NiftiBytes().put<std::int16_t>(field::dim, std::vector<std::int16_t>(dim));
  };
  EXPECT_EQ(read(dims({4, 4, 3, 2, 1})), numbers());
  EXPECT_EQ(read(dims({7, 4, 3, 2, 1, 1, 1, 1})), numbers());
  EXPECT_EQ(read(dims({4, 4, 3, 2, 0})), numbers());
  EXPECT_EQ(read(dims({3, 4, 3, 2, 9, 9, 9, 9})), numbers()); // beyond dim[0]: no meaning
  EXPECT_EQ(remark(), "");
  expect_error([&] { read(dims({4, 4, 3, 1, 2})); }, {"4 dimensions", "2 volumes"});
  expect_error([&] { read(dims({5, 2, 2, 2, 1, 3})); }, {"3 values per voxel"});
  expect_error([&] { read(dims({2, 4, 6, 1})); }, {"2 dimensions"});
  expect_error([&] { read(dims({1, 24, 1, 1})); }, {"1 dimension,"});
  for (const std::int16_t bad : {0, -1, 8, 300})
    expect_error([&] { read(dims({bad, 4, 3, 2, 1})); }, {"image.nii", "dimensions"});
  for (const std::int16_t bad : {0, -4})
    expect_error([&] { read(dims({3, 4, bad, 2, 1})); }, {"image.nii", "axis 2"});
}

TEST_F(NiftiValues, AreCountedBeforeMemoryIsTaken) {
  const auto vast =
      NiftiBytes().put<std::int16_t>(field::dim, {3, 30000, 30000, 30000, 1, 1, 1, 1});
  expect_error([&] { read(vast); }, {"image.nii", "30000 x 30000 x 30000"});
  const auto large = NiftiBytes().put<std::int16_t>(field::dim, {3, 1200, 1200, 1200});
  expect_error([&] { read(large); }, {"image.nii", "damaged or incomplete", "3456000000 bytes"});
  write_gzip(large.all(), folder_ / "image.nii.gz");
  expect_error([&] { read(folder_ / "image.nii.gz"); }, {"image.nii.gz", "unpacked"});
  write_bytes(NiftiBytes().all().substr(0, 390), file_);
  expect_error([&] { read(file_); }, {"image.nii", "damaged or incomplete"});
  write_bytes(NiftiBytes().all().substr(0, 200), file_);
  expect_error([&] { read(file_); }, {"image.nii"});
}

TEST_F(NiftiValues, BeginWhereTheHeaderSays) {
  auto bytes = NiftiBytes().behind_header(std::string(64, 'x')); // an extension
  EXPECT_EQ(read(bytes.put<float>(field::vox_offset, {416.f})), numbers());
  EXPECT_EQ(remark(), "");
  EXPECT_EQ(read(NiftiBytes().put<float>(field::vox_offset, {0.f})), numbers());
  expect_remark("byte 352 was assumed");
  for (const float bad : {nan, -352.f, 100.f, 352.5f, 1e30f, infinity})
    expect_error([&] { read(NiftiBytes().put<float>(field::vox_offset, {bad})); },
                 {"image.nii", "voxels begin at byte"});
  for (const float bad : {353.f, 1e9f})
    expect_error([&] { read(NiftiBytes().put<float>(field::vox_offset, {bad})); },
                 {"image.nii", "damaged or incomplete"});
  EXPECT_EQ(read(NiftiBytes().behind_voxels("more")), numbers());
  expect_remark("goes on behind");
}

TEST_F(NiftiValues, AreUnpackedByContentsAndNotByName) {
  const auto named = [&](const char* name) { return folder_ / name; };
  write_gzip(NiftiBytes().all(), named("packed.nii"));
  write_bytes(NiftiBytes().all(), named("plain.nii.gz"));
  write_gzip(NiftiBytes().all(), named("CAPITALS.NII.GZ"));
  write_gzip(NiftiBytes().all(), named("no ending"));
  for (const char* name : {"packed.nii", "plain.nii.gz", "CAPITALS.NII.GZ", "no ending"})
    EXPECT_EQ(read(named(name)), numbers()) << name;
  // a neighbour of the same name is another file
  write_bytes(NiftiBytes().voxels<std::int16_t>(4, std::vector<std::int16_t>(24, 7)).all(),
              named("twin.nii"));
  write_gzip(NiftiBytes().all(), named("twin.nii.gz"));
  EXPECT_EQ(read(named("twin.nii.gz")), numbers());
  EXPECT_EQ(read(named("twin.nii")), std::vector<float>(24, 7.f));
}

TEST_F(NiftiValues, OfDamagedPackedFilesAreRefused) {
  const auto file = folder_ / "image.nii.gz";
  write_gzip(NiftiBytes().all(), file);
  const auto size = std::filesystem::file_size(file);
  for (const std::size_t missing : {1, 4, 8, 20}) {
    write_gzip(NiftiBytes().all(), file);
    std::filesystem::resize_file(file, size - missing);
    expect_error([&] { read(file); }, {"image.nii.gz", "damaged or incomplete"});
  }
}

TEST_F(NiftiValues, OfPairsAreInTheSecondFile) {
  auto bytes = NiftiBytes().put<char>(field::magic, {'n', 'i', '1'});
  bytes.put<float>(field::vox_offset, {0.f});
  const auto header = folder_ / "pair.hdr", voxels = folder_ / "pair.img";
  write_bytes(bytes.header(), header);
  expect_error([&] { read(header); }, {"pair.hdr", "pair.img", "neither"});
  write_bytes(bytes.voxels(), voxels);
  EXPECT_EQ(read(header), numbers());
  EXPECT_EQ(read(voxels), numbers());
  EXPECT_EQ(remark(), "");
  write_gzip(bytes.voxels(), folder_ / "pair.img.gz");
  expect_error([&] { read(header); }, {"pair.img.gz", "both"});
  std::filesystem::remove(voxels);
  EXPECT_EQ(read(header), numbers());
}

TEST_F(NiftiValues, OfFilesThatAreNotMarkedAreRefused) {
  expect_error(
      [&] {
        read(NiftiBytes().put<char>(field::magic, {'\0', '\0', '\0'}));
      },
      {"image.nii", "Analyze", "left and right"});
  EXPECT_EQ(read(NiftiBytes().put<std::int32_t>(0, {0})), numbers());
  expect_remark("length");
  EXPECT_EQ(read(NiftiBytes(true).put<std::int32_t>(0, {7})), numbers());
}

TEST_F(NiftiValues, OfVersion2AreRead) {
  for (const bool swapped : {false, true}) {
    const NiftiBytes order(swapped);
    NiftiBytes bytes(swapped);
    bytes.behind_header(std::string(544 - 352, '\0'));
    bytes.put<char>(0, std::vector<char>(544, '\0'));
    bytes.put<std::int32_t>(0, {540});
    bytes.put<char>(4, {'n', '+', '2', '\0', '\r', '\n', '\032', '\n'});
    bytes.put<std::int16_t>(12, {4, 16});
    bytes.put<std::int64_t>(16, {3, 4, 3, 2, 1, 1, 1, 1});
    bytes.put<double>(104, {1., 1.5, 2., 3.});
    bytes.put<std::int64_t>(168, {544});
    bytes.put<double>(176, {1., 1.});
    bytes.put<std::int32_t>(344, {1, 0});
    bytes.put<double>(376, {10., 20., 30.});
    bytes.put<std::int32_t>(500, {2});
    auto expected = numbers();
    for (float& value : expected)
      value += 1.f;
    EXPECT_EQ(read(bytes), expected);
    EXPECT_EQ(read_image(file_).grid.origin, dealii::Point<3>(-10., -20., 30.));
    auto vast = bytes;
    vast.put<std::int64_t>(16, {3, 1ll << 62, 1ll << 62, 1ll << 62});
    expect_error([&] { read(vast); }, {"image.nii", "voxels"});
    bytes.put<char>(4, {'n', '+', '2', '\0', '\n', '\n', '\032', '\n'});
    expect_error([&] { read(bytes); }, {"image.nii", "as if it were text"});
  }
}

TEST_F(NiftiValues, AreLabelsIfIntegersWereMeant) {
  const float slope = 3.f / 65535.f;
  std::vector<std::int16_t> stored(24);
  for (std::size_t v = 0; v < 24; ++v)
    stored[v] = static_cast<std::int16_t>(std::floor((double(v % 4) - 1.5) / double(slope)));
  auto bytes = NiftiBytes().put<float>(field::scl_slope, {slope, 1.5f});
  write_bytes(bytes.voxels(4, stored).all(), file_);
  const LabelImage labels = read_labels(file_, remarks_);
  for (std::size_t v = 0; v < 24; ++v)
    EXPECT_EQ(labels.values[v], v % 4);
  expect_remark("rounded");
  // eight bits for labels up to 7 are off by up to 0.014
  std::vector<std::uint8_t> coarse(24);
  for (std::size_t v = 0; v < 24; ++v)
    coarse[v] = static_cast<std::uint8_t>(std::lround(double(v % 8) * 255. / 7.));
  bytes = NiftiBytes().put<float>(field::scl_slope, {7.f / 255.f, 0.f});
  write_bytes(bytes.voxels(2, coarse).all(), file_);
  EXPECT_EQ(read_labels(file_).values[6], 6);
  for (const float bad : {1.5f, 1.01f, -0.5f}) {
    std::vector<float> values(24, 1.f);
    values[4] = bad;
    write_bytes(NiftiBytes().voxels(16, values).all(), file_);
    expect_error([&] { read_labels(file_); }, {"image.nii", "integers from 0 to 255"});
  }
}

TEST_F(NiftiValues, AreReadOrRefusedWhateverTheHeaderHolds) {
  std::mt19937 random(3);
  unsigned n_read = 0;
  for (unsigned i = 0; i < 20000; ++i) {
    std::string bytes = NiftiBytes(i % 2 == 1).all();
    const unsigned n_changes = 1 + random() % 4;
    for (unsigned change = 0; change < n_changes; ++change)
      bytes[random() % 352] = static_cast<char>(random());
    Remarks untold;
    try {
      parse_nifti_header(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                         "image.nii", untold);
      ++n_read;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(n_read, 1000u);
  EXPECT_LT(n_read, 19900u);
}

} // namespace
} // namespace prosup::tests
