#include "prosup/registration/inputs.h"

#include <gtest/gtest.h>

#include <fstream>

#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "temporary_folder.h"

namespace prosup::tests {
namespace {

using namespace prosup::registration;
using image::LabelImage;

const std::string data = PROSUP_TEST_DATA "/small/";

/// The part of the labels that starts at `first` and has every voxel up to `size`.
LabelImage cropped(const LabelImage& labels, const std::array<std::size_t, 3>& first,
                   const std::array<std::size_t, 3>& size) {
  image::VoxelGrid grid = labels.grid;
  grid.size = size;
  grid.origin = labels.grid.physical(double(first[0]), double(first[1]), double(first[2]));
  LabelImage result(grid);
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i)
        result(i, j, k) = labels(first[0] + i, first[1] + j, first[2] + k);
  return result;
}

/// A segmentation of 3D Slicer with the labels that `names` calls 1, 2, ...
void write_segmentation(const LabelImage& labels, const std::vector<std::string>& names,
                        const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  const auto& grid = labels.grid;
  out << "NRRD0005\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: "
      << grid.size[0] << " " << grid.size[1] << " " << grid.size[2] << "\nspace directions:";
  for (unsigned a = 0; a < 3; ++a)
    out << " (" << grid.direction[0][a] * grid.spacing[a] << ","
        << grid.direction[1][a] * grid.spacing[a] << "," << grid.direction[2][a] * grid.spacing[a]
        << ")";
  out << "\nspace origin: (" << grid.origin[0] << "," << grid.origin[1] << "," << grid.origin[2]
      << ")\nencoding: raw\n";
  for (std::size_t s = 0; s < names.size(); ++s)
    out << "Segment" << s << "_ID:=Segment_" << s + 1 << "\nSegment" << s << "_Name:=" << names[s]
        << "\nSegment" << s << "_LabelValue:=" << s + 1 << "\nSegment" << s << "_Layer:=0\n";
  out << "\n";
  out.write(reinterpret_cast<const char*>(labels.values.data()), long(labels.values.size()));
}

// As 3D Slicer saves it: the smallest box around what is labelled, numbered in the order of the
// segments.
TEST(Inputs, ACroppedSegmentationComesToTheGridOfItsImage) {
  const LabelImage whole = image::read_labels(data + "prone_labels.nii.gz");
  std::size_t last = 0; // row of voxels along the second axis that is labelled
  for (std::size_t v = 0; v < whole.values.size(); ++v)
    if (whole.values[v] != 0)
      last = std::max(last, v / whole.grid.size[0] % whole.grid.size[1]);
  ASSERT_LT(last + 1, whole.grid.size[1]);
  LabelImage saved = cropped(whole, {0, 0, 0}, {whole.grid.size[0], last + 1, whole.grid.size[2]});
  for (std::uint8_t& label : saved.values) // fat 1, gland 2, chest 3
    label = label == 0 ? 0 : label == 1 ? 3 : std::uint8_t(label - 1);
  const TemporaryFolder folder;
  write_segmentation(saved, {"Fat", "Gland", "Chest wall"}, folder / "prone.seg.nrrd");

  CaseFiles files;
  files.images = {data + "prone.nii.gz", data + "supine.nrrd"};
  files.labels = {folder / "prone.seg.nrrd", data + "supine_labels.mha"};
  files.excluded.prone = folder / "prone.seg.nrrd";
  const Labels labels;
  const InputReader reader(labels);
  Remarks remarks;
  const SingleInput input = reader.read_breast(files, Position::prone, remarks);
  EXPECT_EQ(input.original->breast.values, image::select_labels(whole, labels.tissues).values);
  ASSERT_EQ(remarks.all().size(), 2u);
  EXPECT_NE(remarks.all()[0].find("numbered by their names"), std::string::npos);
  EXPECT_NE(remarks.all()[1].find("nearest voxel"), std::string::npos);

  files.labels.prone = data + "prone_labels.nii.gz";
  Remarks untold;
  const Inputs expected = reader.read_pair(files, MPI_COMM_SELF, untold);
  files.labels.prone = folder / "prone.seg.nrrd";
  const Inputs inputs = reader.read_pair(files, MPI_COMM_SELF, untold);
  EXPECT_EQ(inputs.scene.labels.prone.values, expected.scene.labels.prone.values);
  EXPECT_EQ(inputs.scene.excluded.prone.grid.size, inputs.scene.labels.prone.grid.size);
  EXPECT_EQ(input.labels.values, inputs.scene.labels.prone.values);
}

// Their air would be taken for the darkest tissue, and the images scaled by it.
TEST(Inputs, IslandsOfTissueInTheAirDoNotChangeTheScaleOfTheImages) {
  CaseFiles files;
  files.images = {data + "prone.nii.gz", data + "supine.nrrd"};
  files.labels = {data + "prone_labels.nii.gz", data + "supine_labels.mha"};
  const Labels labels;
  const InputReader reader(labels);
  Remarks remarks;
  const Inputs expected = reader.read_pair(files, MPI_COMM_SELF, remarks);

  LabelImage islands = image::read_labels(files.labels.prone);
  std::size_t n_islands = 0;
  const auto& size = islands.grid.size;
  const LabelImage air = image::select_labels(islands, {0});
  for (std::size_t k = 1; k + 1 < size[2]; k += 3)
    for (std::size_t j = 1; j + 1 < size[1]; j += 3)
      for (std::size_t i = 1; i + 1 < size[0]; i += 3) {
        bool in_air = true;
        for (std::size_t n = 0; n < 27; ++n)
          in_air = in_air && air(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1) != 0;
        if (in_air) {
          islands(i, j, k) = 2;
          ++n_islands;
        }
      }
  ASSERT_GT(n_islands, 100u);
  const TemporaryFolder folder;
  files.labels.prone = folder / "islands.nii.gz";
  image::write_labels(islands, files.labels.prone);
  const Inputs inputs = reader.read_pair(files, MPI_COMM_SELF, remarks);
  EXPECT_EQ(inputs.originals.prone.breast.values, expected.originals.prone.breast.values);
  EXPECT_EQ(inputs.images.prone.values, expected.images.prone.values);
}

} // namespace
} // namespace prosup::tests
