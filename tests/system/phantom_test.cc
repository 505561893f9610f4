#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "all_files_known.h"
#include "prosup/evaluation/landmarks.h"
#include "prosup/image/image_io.h"
#include "prosup/output/vtu.h"
#include "small_registration.h"

namespace prosup::tests {
namespace {

constexpr const char* small_phantom = PROSUP_PRM_FOLDER "/tests/phantom_small.prm";

/// A displacement field between its voxel centres, interpolated linearly.
dealii::Point<3> moved(const image::VectorImage& field, const dealii::Point<3>& X) {
  const auto index = field.grid.continuous_index(X);
  dealii::Point<3> x = X;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double weight = 1.;
    std::size_t voxel[3];
    for (unsigned d = 0; d < 3; ++d) {
      const double first = std::floor(index[d]), t = index[d] - first;
      const bool upper = corner >> d & 1u;
      voxel[d] = static_cast<std::size_t>(first) + upper;
      weight *= upper ? t : 1. - t;
    }
    for (unsigned d = 0; d < 3; ++d)
      x[d] += weight * field(voxel[0], voxel[1], voxel[2])[d];
  }
  return x;
}

bool has_neighbours(const image::VoxelGrid& grid, const dealii::Point<3>& X) {
  const auto index = grid.continuous_index(X);
  for (unsigned d = 0; d < 3; ++d)
    if (index[d] < 0. || index[d] >= double(grid.size[d]) - 1.)
      return false;
  return true;
}

class PhantomCommand : public ::testing::Test {
protected:
  /// Makes the small phantom and returns the folder.
  std::filesystem::path make(const std::string& name, const std::vector<std::string>& settings,
                             unsigned n_ranks = 1) const {
    std::vector<std::string> arguments{"phantom", small_phantom, "--output", folder_ / name};
    for (const std::string& setting : settings)
      arguments.insert(arguments.end(), {"--set", setting});
    const ProgramRun run = run_prosup(arguments, n_ranks);
    EXPECT_EQ(run.exit_code, 0) << run.transcript();
    return folder_ / name;
  }

  const TemporaryFolder folder_;
};

TEST_F(PhantomCommand, LeavesThePetscOptionsOfItsUserAlone) {
  std::ofstream(folder_ / ".petscrc") << "-log_view\n";
  const char* found = std::getenv("HOME");
  const std::string home = found != nullptr ? found : "";
  ::setenv("HOME", std::string(folder_ / "").c_str(), 1);
  const ProgramRun run =
      run_prosup({"phantom", small_phantom, "--output", folder_ / "one", "--quiet"});
  ::setenv("HOME", home.c_str(), 1);
  EXPECT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_EQ(run.out + run.err, "");
}

TEST_F(PhantomCommand, IsTheSameOnTwoRanks) {
  const std::vector<std::string> finer{"Quasi-static/Tolerance=1e-10"};
  const auto one = make("one", finer), two = make("two", finer, 2);
  const auto a = evaluation::read_landmarks(one / "landmarks.csv"),
             b = evaluation::read_landmarks(two / "landmarks.csv");
  ASSERT_EQ(a.size(), 100u);
  ASSERT_EQ(b.size(), a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_LT(a[i].prone.distance(b[i].prone), 3e-6); // mm; the files hold 1e-6
    EXPECT_LT(a[i].supine.distance(b[i].supine), 3e-6);
    EXPECT_EQ(*a[i].unloaded, *b[i].unloaded);
  }
}

TEST_F(PhantomCommand, FieldsLeadToTheLandmarks) {
  const auto result = make("phantom", {"Phantom/Images/Voxel edge=1.5"});
  expect_all_files_known(result, {"phantom", small_phantom});
  const auto landmarks = evaluation::read_landmarks(result / "landmarks.csv");
  const auto prone = image::read_displacement(result / "unloaded_to_prone.nrrd"),
             supine = image::read_displacement(result / "unloaded_to_supine.nrrd");
  std::vector<double> errors;
  double farthest = 0.;
  for (const auto& landmark : landmarks) {
    const auto& X = *landmark.unloaded;
    if (!has_neighbours(prone.grid, X))
      continue;
    errors.push_back(moved(prone, X).distance(landmark.prone));
    errors.push_back(moved(supine, X).distance(landmark.supine));
    farthest = std::max(farthest, X.distance(landmark.prone));
  }
  ASSERT_GT(errors.size(), 150u);
  EXPECT_GT(farthest, 4.); // mm, of motion
  std::sort(errors.begin(), errors.end());
  // Strains jump between the linear parts, where interpolation cuts the corner.
  EXPECT_LT(errors[errors.size() * 9 / 10], 0.05); // mm
  EXPECT_LT(errors.back(), 0.3);
}

TEST_F(PhantomCommand, WritesWhatACaseHolds) {
  const auto result =
      make("phantom", {"Phantom/Mechanics/Chest=sliding", "Phantom/Images/Supine modality=CT",
                       "Phantom/Images/Rotation=0,0,6", "Phantom/Images/Supine offset=0.3,0.3,0.3",
                       "Phantom/Mechanics/Push pressure=100", "Phantom/Images/Label jitter=1",
                       "Phantom/Images/Bias field=0.1"});
  for (const char* state : {"prone", "supine", "unloaded"}) {
    const auto picture = image::read_image(result / (std::string(state) + ".nii.gz"));
    const auto labels = image::read_labels(result / (std::string(state) + "_labels.nii.gz"));
    EXPECT_TRUE(labels.grid.coincides_with(picture.grid)) << state;
    for (const unsigned label : {1u, 2u, 3u})
      image::require_label(labels, label, "tissue", state);
  }
  const Json truth = read_json(result / "truth.json");
  EXPECT_EQ(truth.at("boundary").at("chest"), "sliding");
  EXPECT_EQ(truth.at("images").at("supine").at("modality"), "CT");
  EXPECT_GT(truth.at("initial_TRE_mm").at("mean").get<double>(), 1.);
  EXPECT_TRUE(read_json(result / "summary.json").at("converged").get<bool>());
}

// What unload found is loaded back to where the breast was.
TEST(Load, UndoesUnload) {
  const TemporaryFolder folder;
  const char* small = PROSUP_PRM_FOLDER "/tests/small.prm";
  ASSERT_EQ(run_prosup({"unload", small, "--output", folder / "unload"}).exit_code, 0);
  const std::string vtu = folder / "unload/prone_loaded.vtu";
  const auto mesh = output::read_mesh(vtu);
  for (const char* solver : {"explicit", "newton"}) {
    const auto result = folder / solver;
    const ProgramRun run = run_prosup({"load", "--chest", "fixed", "--output", result, "--set",
                                       "Single state/Mesh=" + vtu, "--set",
                                       std::string("Single state/Solver=") + solver});
    ASSERT_EQ(run.exit_code, 0) << run.transcript();
    EXPECT_EQ(read_json(result / "summary.json").at("command"), "load");
    const auto loaded = output::read_mesh(result / "prone_loaded.vtu");
    ASSERT_EQ(loaded.mesh.points.size(), mesh.mesh.points.size());
    double error = 0., motion = 0.;
    for (std::size_t i = 0; i < mesh.unloaded.size(); ++i) {
      EXPECT_EQ(loaded.unloaded[i], mesh.unloaded[i]);
      error = std::max(error, loaded.mesh.points[i].distance(mesh.mesh.points[i]));
      motion = std::max(motion, mesh.unloaded[i].distance(mesh.mesh.points[i]));
    }
    EXPECT_GT(motion, 5.); // mm
    EXPECT_LT(error, 0.1); // mm; both stop at a residual of 2e-3
  }
}

// With the material and the springs that it was made with, tissue that slides on the
// chest is unloaded to the truth, by either solver; held fixed it is not.
TEST_F(PhantomCommand, TissueThatSlidesIsUnloadedToTheTruth) {
  const auto phantom =
      make("phantom", {"Phantom/Mechanics/Chest=sliding", "Phantom/Mechanics/Gland ratio=1",
                       "Phantom/Mechanics/Fascia stiffness=4", "Phantom/Images/Voxel edge=2"});
  const auto error = [&](const std::string& chest, const std::string& state,
                         const std::string& solver) {
    const auto result = folder_ / (chest + state + solver);
    const ProgramRun run = run_prosup({"unload",
                                       "--set",
                                       "Case/State=" + state,
                                       "--chest",
                                       chest,
                                       "--prone-labels",
                                       phantom / "prone_labels.nii.gz",
                                       "--supine-labels",
                                       phantom / "supine_labels.nii.gz",
                                       "--landmarks",
                                       phantom / "landmarks.csv",
                                       "--set",
                                       "Material/Shear modulus=300",
                                       "--set",
                                       "Material/Poisson ratio=0.45",
                                       "--set",
                                       "Supports/Chest stiffness=4",
                                       "--set",
                                       "Supports/Cut planes=common",
                                       "--set",
                                       "Single state/Solver=" + solver,
                                       "--output",
                                       result});
    EXPECT_EQ(run.exit_code, 0) << run.transcript();
    return read_json(result / "summary.json").at("tre").at("unloaded").at("mean").get<double>();
  };
  for (const std::string state : {"prone", "supine"}) {
    const double found = error("sliding", state, "explicit");
    EXPECT_LT(found, 0.5) << state; // mm
    EXPECT_NEAR(error("sliding", state, "newton"), found, 0.05) << state;
    EXPECT_GT(error("fixed", state, "explicit"), 2. * found) << state;
  }
}

// The truth has quadratic elements and Newton's method, the unloading linear ones and time steps.
TEST_F(PhantomCommand, SkinIsUnloadedToTheTruthAndFound) {
  const auto phantom =
      make("phantom", {"Phantom/Mechanics/Skin stiffness=5000", "Phantom/Mechanics/Gland ratio=1"});
  const auto run = [&](const std::vector<std::string>& more) {
    const auto result = folder_ / "result";
    std::vector<std::string> arguments = more;
    for (const std::string state : {"prone", "supine"})
      arguments.insert(arguments.end(),
                       {"--" + state + "-labels", phantom / (state + "_labels.nii.gz")});
    arguments.insert(arguments.end(), {"--landmarks", phantom / "landmarks.csv", "--chest", "fixed",
                                       "--output", result});
    const ProgramRun done = run_prosup(arguments, 2);
    EXPECT_EQ(done.exit_code, 0) << done.transcript();
    return read_json(result / "summary.json");
  };
  const auto unloading_error = [&](const std::string& state, const std::string& skin) {
    return run({"unload", "--set", "Case/State=" + state, "--set", "Material/Shear modulus=300",
                "--set", "Supports/Cut planes=common", "--set", "Material/Skin stiffness=" + skin})
        .at("tre")
        .at("unloaded")
        .at("mean")
        .get<double>();
  };
  EXPECT_LT(unloading_error("prone", "5000"), 0.5 * unloading_error("prone", "0"));
  EXPECT_LT(unloading_error("supine", "5000"), 0.2); // mm; most of its skin is slack

  const Json found = run({"register", "--prone-image", phantom / "prone.nii.gz", "--supine-image",
                          phantom / "supine.nii.gz", "--set", "Results/Pictures=false", "--set",
                          "Material update/Properties=shear modulus, Poisson ratio, "
                          "gland ratio, cut plane stiffness, gravity, skin stiffness"});
  EXPECT_GT(found.at("material").at("skin_stiffness"), 2500.);
  EXPECT_LT(found.at("material").at("skin_stiffness"), 10000.);
  EXPECT_LT(found.at("tre").at("image_forces").at("mean"), 0.5);
}

TEST(Load, LoadsLabelsAndTheirImage) {
  const TemporaryFolder folder;
  const auto result = folder / "load";
  const ProgramRun run =
      run_prosup({"load", PROSUP_PRM_FOLDER "/tests/small.prm", "--output", result}, 2);
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  expect_all_files_known(result, {"load", PROSUP_PRM_FOLDER "/tests/small.prm"});
  const auto field = image::read_displacement(result / "prone_to_unloaded.nrrd");
  EXPECT_TRUE(field.grid.coincides_with(image::read_image(result / "prone_loaded.nii.gz").grid));
  EXPECT_TRUE(std::filesystem::exists(result / "unloaded_to_prone.nrrd"));
  EXPECT_TRUE(std::filesystem::exists(result / "slices_axial.png"));
}

} // namespace
} // namespace prosup::tests
