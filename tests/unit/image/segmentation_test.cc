#include "prosup/image/segmentation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "expect_error.h"
#include "image/segments.h"
#include "nrrd_text.h"
#include "prosup/image/image_io.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

struct Named {
  std::string name;
  int value = -1; // none
  int layer = -1;
};

std::string keys(const std::vector<Named>& segments) {
  std::string text;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::string key = "Segment" + std::to_string(s) + "_";
    text += key + "ID:=Segment_" + std::to_string(s + 1) + "\n" + key +
            "Name:=" + segments[s].name + "\n";
    if (segments[s].value >= 0)
      text += key + "LabelValue:=" + std::to_string(segments[s].value) + "\n";
    if (segments[s].layer >= 0)
      text += key + "Layer:=" + std::to_string(segments[s].layer) + "\n";
  }
  return text;
}

class Segmentation : public ::testing::Test {
protected:
  /// A segmentation with the values of 12 voxels, all layers of one voxel together.
  std::filesystem::path file(const std::vector<Named>& segments, const std::string& bytes) {
    std::string header = nrrd_fields();
    if (bytes.size() > 12) {
      header.replace(header.find("dimension: 3"), 12, "dimension: 4");
      header.replace(header.find("3 2 2"), 5, std::to_string(bytes.size() / 12) + " 3 2 2");
      header.replace(header.find("directions: "), 12, "directions: none ");
      header += "kinds: list domain domain domain\n";
    }
    return text_file(folder_ / "a.seg.nrrd",
                     header + "encoding: raw\n" + keys(segments) + "\n" + bytes);
  }

  std::vector<int> read(const std::vector<Named>& segments, const std::string& bytes) {
    remarks_ = Remarks();
    const LabelImage image = read_tissues(file(segments, bytes), labels_, remarks_);
    EXPECT_EQ(image.grid.origin, Point<3>(10., 20., 30.));
    return std::vector<int>(image.values.begin(), image.values.end());
  }

  void expect_remarks(const std::vector<std::string>& parts) {
    ASSERT_EQ(remarks_.all().size(), parts.size());
    for (std::size_t r = 0; r < parts.size(); ++r) {
      EXPECT_NE(remarks_.all()[r].find(parts[r]), std::string::npos) << remarks_.all()[r];
      EXPECT_NE(remarks_.all()[r].find("a.seg.nrrd"), std::string::npos);
    }
  }

  TemporaryFolder folder_;
  Labels labels_; // chest 1, tissues 2 and 3, gland 3
  Remarks remarks_;
};

TEST(SegmentNames, SayWhatTheyAre) {
  const std::vector<std::pair<SegmentKind, std::vector<std::string>>> kinds{
      {SegmentKind::chest, {"chest", "Chest wall", "THORAX", "Pectoralis major", "muscle", "ribs"}},
      {SegmentKind::gland,
       {"gland", "Glandular tissue", "fibroglandular_tissue", "FGT", "breast parenchyma",
        "mammary gland"}},
      {SegmentKind::fat,
       {"fat", "Fatty tissue", "adipose", "subcutaneous fat", "breast fat (left)"}},
      {SegmentKind::skin, {"skin", "Skin 2", "nipple"}},
      {SegmentKind::breast, {"breast", "Left breast", "breast tissue", "mamma"}},
      {SegmentKind::air, {"background", "Air"}},
      {SegmentKind::unknown,
       {"", "Segment_1", "tumour in gland", "breast implant", "fat and gland", "cyst", "42"}}};
  for (const auto& [kind, names] : kinds)
    for (const std::string& name : names)
      EXPECT_EQ(kind_of_segment(name), kind) << name;
}

TEST_F(Segmentation, NamesGiveTheNumbers) {
  const std::string bytes = "\1\2\3\1\2\3\1\2\3\1\2" + std::string(1, '\0');
  EXPECT_EQ(read({{"Chest", 1}, {"fat", 2}, {"Gland", 3}}, bytes),
            (std::vector<int>{1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 0}));
  expect_remarks({});
  EXPECT_EQ(read({{"fat", 1}, {"gland", 2}, {"chest", 3}}, bytes),
            (std::vector<int>{2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3, 0}));
  expect_remarks({"'fat' (1) as 2, 'gland' (2) as 3, 'chest' (3) as 1"});
  labels_.chest = 30;
  labels_.tissues = {10, 20};
  labels_.gland = 0;
  EXPECT_EQ(read({{"fat", 1}, {"gland", 2}, {"muscle", 3}}, bytes),
            (std::vector<int>{10, 10, 30, 10, 10, 30, 10, 10, 30, 10, 10, 0}));
}

TEST_F(Segmentation, SkinIsFatAndOtherThingsAreNamed) {
  const std::string bytes = "\1\2\3\4\5\6\1\2\3\4\5" + std::string(1, '\0');
  EXPECT_EQ(
      read({{"chest", 1}, {"fat", 2}, {"gland", 3}, {"skin", 4}, {"cyst", 5}, {"?", 6}}, bytes),
      (std::vector<int>{1, 2, 3, 2, 5, 6, 1, 2, 3, 2, 5, 0}));
  expect_remarks({"'skin' (4) as 2", "'cyst' (label 5), '?' (label 6)"});
  // A number that the tissues use is not given to anything else.
  EXPECT_EQ(read({{"chest", 4}, {"fat", 5}, {"cyst", 1}, {"gland", 6}}, bytes)[0], 4);
  expect_remarks({"by their names", "'cyst' (label 4)", "4 voxels have a value"});
}

TEST_F(Segmentation, NamesThatSayNothingLeaveTheNumbers) {
  const std::string bytes = "\1\2\3\1\2\3\1\2\3\1\2" + std::string(1, '\0');
  EXPECT_EQ(read({{"Segment_1", 1}, {"Segment_2", 2}, {"Segment_3", 3}}, bytes)[2], 3);
  expect_remarks({"'Segment_1' is 1"});
  const auto large = file({{"Segment_1", 300}}, bytes);
  expect_error([&] { read_tissues(large, labels_, remarks_); }, {"a.seg.nrrd", "300", "0 to 255"});
}

TEST_F(Segmentation, LayersAreMergedByRank) {
  // Layers: chest 1 and fat 2; gland 1; whole breast 1.
  std::string bytes;
  for (const char* voxel : {"100", "200", "010", "110", "210", "001", "101", "211"})
    for (const char* layer = voxel; *layer != '\0'; ++layer)
      bytes += static_cast<char>(*layer - '0');
  bytes += std::string(12, '\0');
  const std::vector<Named> segments{
      {"chest", 1, 0}, {"fat", 2, 0}, {"gland", 1, 1}, {"left breast", 1, 2}};
  EXPECT_EQ(read(segments, bytes), (std::vector<int>{1, 2, 3, 1, 3, 2, 1, 3, 0, 0, 0, 0}));
  expect_remarks({"by their names", "overlap in 4 voxels"});
  EXPECT_EQ(read_mask(file(segments, bytes), remarks_).values,
            (std::vector<std::uint8_t>{1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0}));
}

// Before Slicer 4.11 there were neither values nor layers.
TEST_F(Segmentation, OldFilesHaveALayerForEachSegment) {
  std::string bytes;
  for (std::size_t v = 0; v < 12; ++v)
    bytes += v % 3 == 0   ? std::string("\1\0\0", 3)
             : v % 3 == 1 ? std::string("\0\1\0", 3)
                          : std::string("\0\0\1", 3);
  EXPECT_EQ(read({{"fat"}, {"chest"}, {"gland"}}, bytes),
            (std::vector<int>{2, 1, 3, 2, 1, 3, 2, 1, 3, 2, 1, 3}));
}

TEST_F(Segmentation, KeysThatContradictEachOtherAreRefused) {
  const std::string bytes(12, '\1');
  const auto refused = [&](const std::vector<Named>& segments, const std::string& part) {
    const auto bad = file(segments, bytes);
    expect_error([&] { read_tissues(bad, labels_, remarks_); }, {"a.seg.nrrd", part});
  };
  refused({{"fat", 1, 1}}, "layer 1");
  refused({{"fat", 1}, {"gland", 1}}, "same value");
  refused({{"fat", 99999}}, "'99999'");
}

// Slicer saves segments on the voxels of the image, which read_image() brings into order.
TEST_F(Segmentation, HasTheOrderOfAxesThatItsImageHas) {
  std::string header = nrrd_fields(); // slices from head to foot
  header.replace(header.find("(2,0,0) (0,2,0) (0,0,2)"), 23, "(2,0,0) (0,-2,0) (0,0,-2)");
  const std::string bytes = "\1\2\3\1\1\2\2\3\3\2\1" + std::string(1, '\0');
  const auto image =
      read_image(text_file(folder_ / "a.nrrd", header + "encoding: raw\n\n" + bytes));
  const auto file = text_file(folder_ / "a.seg.nrrd",
                              header + "encoding: raw\n" +
                                  keys({{"chest", 1}, {"fat", 2}, {"gland", 3}}) + "\n" + bytes);
  const LabelImage tissues = read_tissues(file, labels_, remarks_);
  EXPECT_TRUE(tissues.grid.coincides_with(image.grid, 1e-9));
  EXPECT_TRUE(std::equal(tissues.values.begin(), tissues.values.end(), image.values.begin()));
  EXPECT_TRUE(read_mask(file, remarks_).grid.coincides_with(image.grid, 1e-9));
}

TEST_F(Segmentation, OtherFilesKeepTheirNumbers) {
  const auto plain =
      text_file(folder_ / "a.nrrd", nrrd_fields() + "encoding: raw\n\n" + counting_bytes(12));
  EXPECT_EQ(read_tissues(plain, labels_, remarks_).values[7], 7);
  EXPECT_EQ(read_mask(plain, remarks_).values[7], 1);
  EXPECT_TRUE(remarks_.all().empty());
}

} // namespace
} // namespace prosup::tests
