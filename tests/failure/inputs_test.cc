#include <algorithm>

#include "prosup/image/image_io.h"
#include "refused.h"

namespace prosup::tests {
namespace {

class Input : public Refused {
protected:
  /// The prone labels of the small case after `change`, in a file.
  template <typename Change>
  std::string changed_labels(const Change& change) const {
    image::LabelImage labels = image::read_labels(data_file("small/prone_labels.nii.gz"));
    change(labels);
    const auto file = folder_ / "labels.nrrd";
    image::write_labels(labels, file);
    return file;
  }

  std::string truncated(const std::string& name) const {
    const std::string whole = contents(data_file(name));
    return write("cut_" + std::filesystem::path(name).filename().string(),
                 whole.substr(0, whole.size() / 2));
  }
};

TEST_F(Input, ImageThatDoesNotExist) {
  const Arguments wrong = registering({"--supine-image", "nowhere/supine.nrrd"});
  expect_refused(wrong, {"nowhere/supine.nrrd", "does not exist"});
  expect_refused(wrong, {"nowhere/supine.nrrd", "does not exist"}, 2);
}

TEST_F(Input, ImageThatIsNotGiven) {
  expect_refused({"register", "--output", output()}, {"Case/Prone image", "--prone-image"});
  expect_refused({"mesh", "--output", output()}, {"Case/Prone labels", "--prone-labels"});
  expect_refused({"unload", "--state", "supine", "--output", output()},
                 {"Case/Supine labels", "--supine-labels"}, 2);
}

TEST_F(Input, ImageThatIsTruncated) {
  for (const char* name : {"small/prone.nii.gz", "small/supine.nrrd"})
    expect_refused(registering({"--prone-image", truncated(name)}), {"cut_", "incomplete"});
  expect_refused(registering({"--prone-labels", truncated("small/supine_labels.mha")}),
                 {"cut_supine_labels.mha", "incomplete"}, 2);
}

TEST_F(Input, ImageThatIsNone) {
  expect_refused(registering({"--prone-image", write("prone.nii.gz", "no image")}),
                 {"prone.nii.gz", "NIfTI", "NRRD", "MetaImage"});
  expect_refused(registering({"--prone-image", PROSUP_TEST_DATA}),
                 {PROSUP_TEST_DATA, "not a file"});
}

TEST_F(Input, ImageInThePlaceOfLabels) {
  image::ScalarImage image = image::read_image(data_file("small/prone.nii.gz"));
  image.values[1000] = 17.5f;
  const auto file = folder_ / "image.nrrd";
  image::write_image(image, file);
  expect_refused(registering({"--prone-labels", file}), {file, "17.5", "0 to 255", "mask"});
}

TEST_F(Input, LabelsThatDoNotFitTheirImage) {
  // Fewer voxels are a cropped mask, which is resampled, unless it lies elsewhere.
  const std::string elsewhere = changed_labels([](auto& labels) {
    --labels.grid.size[2];
    labels.values.resize(labels.grid.n_voxels());
    labels.grid.origin[0] += 300.;
  });
  expect_refused(registering({"--prone-labels", elsewhere}),
                 {elsewhere, "prone.nii.gz", "lie elsewhere", "only 0 %", "origin"});
  const std::string moved = changed_labels([](auto& labels) { labels.grid.origin[2] += 5.; });
  expect_refused(registering({"--prone-labels", moved}), {moved, "prone.nii.gz", "origin"});
  expect_refused({"unload", PROSUP_PRM_FOLDER "/tests/small.prm", "--output", output(),
                  "--prone-labels", moved},
                 {moved, "prone.nii.gz", "origin"}, 2);
}

TEST_F(Input, EmptyMask) {
  const std::string empty = changed_labels(
      [](auto& labels) { std::fill(labels.values.begin(), labels.values.end(), 0); });
  for (const unsigned n_ranks : {1u, 2u})
    expect_refused(registering({"--prone-labels", empty}), {empty, "empty"}, n_ranks);
  expect_refused({"mesh", "--prone-labels", empty, "--output", output()}, {empty, "empty"});
}

TEST_F(Input, LabelThatIsNotThere) {
  expect_refused(registering({"--set", "Labels/Chest=9"}),
                 {"prone_labels.nii.gz", "no voxel of label 9", "chest", "0, 1, 2, 3"});
  expect_refused(registering({"--set", "Labels/Tissues=7", "--set", "Labels/Gland=0"}),
                 {"prone_labels.nii.gz", "no voxel of label 7", "Labels/Tissues", "0, 1, 2, 3"});
}

TEST_F(Input, MaskWithHardlyABreast) {
  const std::string speck = changed_labels([](auto& labels) {
    bool kept = false;
    for (auto& label : labels.values)
      if (label > 1) {
        label = kept ? 0 : label;
        kept = true;
      }
  });
  expect_refused({"mesh", "--prone-labels", speck, "--output", output()},
                 {"breast mask", "too small", "Meshing/Edge length"});
}

TEST_F(Input, LandmarksWithABadNumber) {
  const std::string file =
      write("landmarks.csv", "id,prone_x,prone_y,prone_z,supine_x,supine_y,supine_z\n"
                             "a,1,2,3,4,5,6\nb,1,2,3,4,nan,6\n");
  expect_refused(registering({"--landmarks", file}), {file, "line 3", "'nan'", "finite"});
  expect_refused(registering({"--landmarks", file}), {file, "line 3"}, 2);
}

TEST_F(Input, LandmarksWithoutAColumn) {
  const std::string file = write("landmarks.csv", "id,prone_x,prone_y,prone_z\na,1,2,3\n");
  expect_refused(registering({"--landmarks", file}), {file, "column 'supine_x'"});
}

// Tissue that floats in the air, away from the chest and the border of the image.
TEST_F(Input, BreastThatNothingHolds) {
  const auto file = changed_labels([](image::LabelImage& labels) {
    const auto& size = labels.grid.size;
    for (std::size_t k = 0; k < size[2]; ++k)
      for (std::size_t j = 0; j < size[1]; ++j)
        for (std::size_t i = 0; i < size[0]; ++i) {
          const bool is_inside =
              i > 2 && j > 2 && k > 2 && i + 3 < size[0] && j + 3 < size[1] && k + 3 < size[2];
          auto& label = labels(i, j, k);
          label = label == 1 || !is_inside ? 0 : label;
        }
    labels(0, 0, 0) = 1;
  });
  for (const char* chest : {"fixed", "sliding"})
    expect_refused(registering({"--prone-labels", file, "--chest", chest}),
                   {"holds", "Supports/Cut planes"});
}

TEST_F(Input, ExcludedRegionOnOtherVoxels) {
  const std::string mask =
      changed_labels([](image::LabelImage& labels) { labels.grid.origin[0] += 5.; });
  const Arguments wrong = registering({"--set", "Case/Prone excluded=" + mask});
  expect_refused(wrong, {"labels.nrrd", "origin"});
}

} // namespace
} // namespace prosup::tests
