#include "all_files_known.h"
#include "prosup/image/image_io.h"
#include "small_registration.h"

namespace prosup::tests {
namespace {

/// Overlap 2 |A and B| / (|A| + |B|) of the voxels with at least `label`.
double dice_from(const image::LabelImage& a, const image::LabelImage& b, unsigned label) {
  double both = 0., sum = 0.;
  for (std::size_t v = 0; v < a.values.size(); ++v) {
    both += a.values[v] >= label && b.values[v] >= label;
    sum += double(a.values[v] >= label) + double(b.values[v] >= label);
  }
  return 2. * both / sum;
}

TEST(Prepare, MakesTheInputOfARegistration) {
  const TemporaryFolder folder;
  const auto output = folder / "case";
  const std::string scan = data_file("anthro1/supine.nii.gz");
  const ProgramRun run = run_prosup({"prepare", "--supine", scan, "--output", output}, 2);
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_NE(run.out.find("bright fat (T1), as recognised"), std::string::npos) << run.out;
  const image::LabelImage labels = image::read_labels(output / "supine_labels.nii.gz");
  const image::LabelImage truth = image::read_labels(data_file("anthro1/supine_labels.nii.gz"));
  ASSERT_EQ(labels.values.size(), truth.values.size());
  EXPECT_GT(dice_from(labels, truth, 1), 0.95);
  EXPECT_GT(dice_from(labels, truth, 2), 0.93);
  EXPECT_GT(dice_from(labels, truth, 3), 0.80);
  const image::ScalarImage gland = image::read_image(output / "supine_gland.nii.gz");
  EXPECT_TRUE(gland.grid.coincides_with(labels.grid));
  const Json scanned = read_json(output / "summary.json").at("preparation").at("supine");
  EXPECT_EQ(scanned.at("contrast"), "t1");
  EXPECT_GT(scanned.at("gland_ml").get<double>(), 50.);
  for (const char* picture : {"supine_axial.png", "supine_sagittal.png", "supine_coronal.png"})
    EXPECT_TRUE(std::filesystem::exists(output / picture)) << picture;
  expect_all_files_known(output, {"prepare", "--supine", scan});

  const ProgramRun mesh = run_prosup({"mesh", output / "case.prm", "--output", folder / "mesh",
                                      "--set", "Meshing/Edge length=12"});
  EXPECT_EQ(mesh.exit_code, 0) << mesh.transcript();
}

// The supine scan is prepared, the prone labels are given; a doubt about the scan is a reason of
// the verdict. A chest that is drawn wins.
TEST(Prepare, IsAStageOfARegistration) {
  const TemporaryFolder folder;
  const auto output = folder / "case";
  const std::vector<std::string> arguments{"register", PROSUP_PRM_FOLDER "/tests/small.prm",
                                           "--set",    "Case/Supine image=",
                                           "--set",    "Case/Supine labels=",
                                           "--set",    "Material update/Method=none",
                                           "--set",    "Image forces/Levels=6",
                                           "--supine", data_file("small/supine.nrrd")};
  std::vector<std::string> with_output = arguments;
  with_output.insert(with_output.end(), {"--output", output});
  const ProgramRun run = run_prosup(with_output, 2);
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  const Json summary = read_json(output / "summary.json");
  EXPECT_EQ(summary.at("preparation").size(), 1u);
  EXPECT_EQ(summary.at("preparation").at("supine").at("contrast"), "t1");
  EXPECT_EQ(summary.at("metric"), "ssd");
  EXPECT_TRUE(std::filesystem::exists(output / "prepared/supine_axial.png"));
  const image::LabelImage labels = image::read_labels(output / "prepared/supine_labels.nii.gz");
  const image::LabelImage truth = image::read_labels(data_file("small/supine_labels.mha"));
  EXPECT_GT(dice_from(labels, truth, 2), 0.9);
  EXPECT_LT(summary.at("tre").at("image_forces").at("mean").get<double>(), 3.); // mm, of 10.4
  expect_all_files_known(output, arguments);
}

} // namespace
} // namespace prosup::tests
