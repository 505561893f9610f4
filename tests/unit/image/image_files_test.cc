#include "prosup/image/image_files.h"

#include <gtest/gtest.h>

#include "nifti_bytes.h"
#include "nrrd_text.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using image::files_of_image;
using Files = std::vector<std::filesystem::path>;

TEST(ImageFiles, AreHeaderAndVoxels) {
  const TemporaryFolder folder;
  const auto first = text_file(folder / "s1.raw", counting_bytes(6));
  const auto second = text_file(folder / "s2.raw", counting_bytes(6));
  const std::string raw = nrrd_fields() + "encoding: raw\n";
  const auto list = text_file(folder / "a.nhdr", raw + "data file: LIST\ns1.raw\ns2.raw\n");
  EXPECT_EQ(files_of_image(list), (Files{list, first, second}));
  const auto one = text_file(folder / "b.nrrd", raw + "\n" + counting_bytes(12));
  EXPECT_EQ(files_of_image(one), Files{one});
  const auto meta = text_file(folder / "c.mhd", "NDims = 3\nDimSize = 3 2 2\nElementType = "
                                                "MET_UCHAR\nElementDataFile = s%d.raw 1 2 1\n");
  EXPECT_EQ(files_of_image(meta), (Files{meta, first, second}));
}

TEST(ImageFiles, OfAPairAreBothByEitherName) {
  const TemporaryFolder folder;
  auto bytes = NiftiBytes().put<char>(nifti_field::magic, {'n', 'i', '1'});
  const auto header = folder / "pair.hdr", voxels = folder / "pair.img";
  write_bytes(bytes.header(), header);
  write_bytes(bytes.voxels(), voxels);
  EXPECT_EQ(files_of_image(header), (Files{header, voxels}));
  EXPECT_EQ(files_of_image(voxels), (Files{voxels, header}));
}

TEST(ImageFiles, OfWhatIsNoImageIsThatFile) {
  const TemporaryFolder folder;
  const auto table = text_file(folder / "points.csv", "id,x,y,z\na,1,2,3\n");
  EXPECT_EQ(files_of_image(table), Files{table});
  EXPECT_EQ(files_of_image(folder / "missing.nrrd"), Files{folder / "missing.nrrd"});
}

} // namespace
} // namespace prosup::tests
