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

} // namespace
} // namespace prosup::tests
