#include "small_registration.h"

namespace prosup::tests {
namespace {

/// Prone MR and supine CT of the small phantom, made once.
const std::filesystem::path& phantom() {
  static const TemporaryFolder folder;
  static const std::filesystem::path made = [] {
    const ProgramRun run = run_prosup({"phantom", PROSUP_PRM_FOLDER "/tests/phantom_small_mrct.prm",
                                       "--output", folder / "phantom"});
    if (run.exit_code != 0)
      throw std::runtime_error("the phantom failed: " + run.transcript());
    return std::filesystem::path(folder / "phantom");
  }();
  return made;
}

/// Target registration errors of a registration of the phantom.
Json errors(const std::string& similarity, const std::string& contrast,
            const std::string& setting = "Material update/Levels=4", int exit_code = 0) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments{"register", "--chest",      "fixed",
                                     "--output", folder / "out", "--similarity",
                                     similarity, "--landmarks",  phantom() / "landmarks.csv"};
  for (const std::string state : {"prone", "supine"})
    arguments.insert(arguments.end(),
                     {"--" + state + "-image", phantom() / (state + ".nii.gz"),
                      "--" + state + "-labels", phantom() / (state + "_labels.nii.gz")});
  for (const char* common :
       {"Meshing/Edge length=10", "Image forces/Levels=4", "Image forces/Updates per level=14",
        "Results/Pictures=false", "Results/Voxel edge=4"})
    arguments.insert(arguments.end(), {"--set", common});
  arguments.insert(arguments.end(), {"--set", "Images/Contrast=" + contrast, "--set", setting});
  const ProgramRun run = run_prosup(arguments);
  EXPECT_EQ(run.exit_code, exit_code) << run.transcript();
  return read_json(folder / "out/summary.json").at("tre");
}

double mean(const Json& errors, const std::string& row) {
  return errors.at(row).at("mean");
}

// Unloading with the generic material leaves nearly 3 mm, and images with voxels
// of 2 mm, compared on voxels of 4 mm, bring it to less than a voxel.
TEST(Contrast, MrAndCtAreRegistered) {
  for (const auto& [similarity, contrast] :
       {std::pair("nmi", "as given"), {"lncc", "as given"}, {"ssd", "prone as supine"}}) {
    const Json found = errors(similarity, contrast);
    EXPECT_GT(mean(found, "unloaded"), 2.) << similarity;
    EXPECT_LT(mean(found, "material"), 0.6 * mean(found, "unloaded")) << similarity;
    EXPECT_LT(mean(found, "image_forces"), 0.4 * mean(found, "unloaded"))
        << similarity << ", " << contrast;
  }
}

// What all this is for. The verdict says so.
TEST(Contrast, SsdOfImagesAsGivenDoesNotRegisterThem) {
  const Json found = errors("ssd", "as given", "Material update/Maximum steps=0", 3);
  EXPECT_GT(mean(found, "image_forces"), 0.6 * mean(found, "unloaded"));
}

} // namespace
} // namespace prosup::tests
