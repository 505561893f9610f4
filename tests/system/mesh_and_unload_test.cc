#include "all_files_known.h"
#include "prosup/image/image_io.h"
#include "prosup/output/vtu.h"
#include "small_registration.h"

namespace prosup::tests {
namespace {

constexpr const char* small = PROSUP_PRM_FOLDER "/tests/small.prm";

TEST(Mesh, WritesTheMeshOfOneStateAndItsQuality) {
  const TemporaryFolder folder;
  const auto output = folder / "mesh";
  const ProgramRun run = run_prosup({"mesh", small, "--state", "supine", "--output", output});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_NE(run.out.find("quality"), std::string::npos) << run.out;

  const Json summary = read_json(output / "summary.json");
  const mesh::UnloadedMesh mesh = output::read_mesh(output / "supine_loaded.vtu");
  EXPECT_EQ(summary.at("mesh").at("supine").at("cells").get<std::size_t>(), mesh.mesh.cells.size());
  EXPECT_EQ(summary.at("mesh").at("supine").at("nodes").get<std::size_t>(),
            mesh.mesh.points.size());
  EXPECT_GT(summary.at("mesh").at("supine").at("min_quality").get<double>(), 0.);
  EXPECT_FALSE(summary.at("mesh").contains("prone"));
  EXPECT_FALSE(summary.contains("tre"));
  expect_all_files_known(output, {"mesh", small, "--state", "supine"});
}

TEST(Mesh, GetsFinerWithTheEdgeLength) {
  const TemporaryFolder folder;
  std::size_t n_cells[2];
  for (const unsigned fine : {0u, 1u}) {
    const auto output = folder / std::to_string(fine);
    const ProgramRun run = run_prosup({"mesh", small, "--output", output, "--set",
                                       std::string("Meshing/Edge length=") + (fine ? "9" : "13")});
    ASSERT_EQ(run.exit_code, 0) << run.transcript();
    n_cells[fine] = read_json(output / "summary.json").at("mesh").at("prone").at("cells");
  }
  // (13/9)^3 = 3 times as many, less where surface rules.
  EXPECT_GT(n_cells[1], 2 * n_cells[0]);
}

// Landmarks belong to pairs; an image is not needed.
TEST(Unload, NeedsOnlyTheLabels) {
  const TemporaryFolder folder;
  const auto output = folder / "unload";
  const ProgramRun run =
      run_prosup({"unload", "--supine-labels", data_file("small/supine_labels.mha"), "--state",
                  "supine", "--output", output, "--set", "Meshing/Edge length=12"});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_TRUE(std::filesystem::exists(output / "unloaded_to_supine.nrrd"));
  EXPECT_FALSE(std::filesystem::exists(output / "supine_unloaded.nii.gz"));
}

TEST(Unload, ShowsWhatTheLogLevelAllows) {
  const TemporaryFolder folder;
  const std::string step = "  prone: step 10, residual ";
  const auto run_at = [&](const std::vector<std::string>& level) {
    std::vector<std::string> arguments{"unload", small, "--output", folder / "unload"};
    arguments.insert(arguments.end(), level.begin(), level.end());
    const ProgramRun run = run_prosup(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.transcript();
    EXPECT_NE(contents(folder / "unload/log.txt").find("  Unloading\n"), std::string::npos);
    return run;
  };
  const ProgramRun usual = run_at({});
  EXPECT_NE(usual.out.find("\nUnloading\n"), std::string::npos) << usual.out;
  EXPECT_EQ(usual.out.find(step), std::string::npos) << usual.out;
  for (const char* what : {"error", "warning"})
    EXPECT_EQ(run_at({"--log-level", what}).out, "");
  EXPECT_EQ(run_at({"--quiet"}).out, "");
  const ProgramRun all = run_at({"--log-level", "debug"});
  EXPECT_NE(all.out.find("\n" + step), std::string::npos) << all.out;
  EXPECT_NE(contents(folder / "unload/log.txt").find(step), std::string::npos);
}

TEST(Unload, IsTheSameOnTwoRanks) {
  const TemporaryFolder folder;
  std::vector<mesh::UnloadedMesh> meshes;
  for (const unsigned n_ranks : {1u, 2u}) {
    const auto output = folder / std::to_string(n_ranks);
    const ProgramRun run = run_prosup({"unload", small, "--output", output}, n_ranks);
    ASSERT_EQ(run.exit_code, 0) << run.transcript();
    EXPECT_TRUE(read_json(output / "summary.json").at("converged").get<bool>());
    EXPECT_TRUE(std::filesystem::exists(output / "prone.pvd"));
    const auto field = image::read_displacement(output / "unloaded_to_prone.nrrd");
    EXPECT_EQ(field.values.size(), field.grid.n_voxels());
    EXPECT_TRUE(
        field.grid.coincides_with(image::read_image(output / "prone_unloaded.nii.gz").grid));
    meshes.push_back(output::read_mesh(output / "prone_loaded.vtu"));
    expect_all_files_known(output, {"unload", small});
  }
  ASSERT_EQ(meshes[0].unloaded.size(), meshes[1].unloaded.size());
  double difference = 0., displacement = 0.;
  for (std::size_t i = 0; i < meshes[0].unloaded.size(); ++i) {
    difference = std::max(difference, meshes[0].unloaded[i].distance(meshes[1].unloaded[i]));
    displacement = std::max(displacement, meshes[0].unloaded[i].distance(meshes[0].mesh.points[i]));
  }
  EXPECT_LT(difference, 0.01); // mm; sums over ranks differ by rounding
  EXPECT_GT(displacement, 5.); // mm
}

// Every element, precision and solver, against averaged pressure and explicit
// motion on the same mesh, whose nodes come first in each.
TEST(Unload, ElementsAndSolversAgree) {
  struct Choice {
    const char *name, *set;
    double bound; ///< mm; of another solver the tolerances, of elements their error
  };
  const TemporaryFolder folder;
  const auto unload = [&](const Choice& choice) {
    const auto output = folder / choice.name;
    const ProgramRun run = run_prosup({"unload", small, "--output", output, "--set", choice.set});
    EXPECT_EQ(run.exit_code, 0) << run.transcript();
    return output::read_mesh(output / "prone_loaded.vtu");
  };
  const mesh::UnloadedMesh averaged = unload({"averaged", "Elements/Type=nodal-pressure", 0.});
  for (const Choice& choice : {Choice{"float", "Elements/Precision=float", 0.01},
                               Choice{"newton", "Single state/Solver=newton", 0.1},
                               Choice{"linear", "Elements/Type=linear", 2.},
                               Choice{"quadratic", "Elements/Type=quadratic", 2.}}) {
    const mesh::UnloadedMesh mesh = unload(choice);
    ASSERT_GE(mesh.unloaded.size(), averaged.unloaded.size()) << choice.name;
    double difference = 0.;
    for (std::size_t i = 0; i < averaged.unloaded.size(); ++i) {
      ASSERT_LT(mesh.mesh.points[i].distance(averaged.mesh.points[i]), 1e-9) << choice.name;
      difference = std::max(difference, mesh.unloaded[i].distance(averaged.unloaded[i]));
    }
    EXPECT_LT(difference, choice.bound) << choice.name;
    const unsigned n_parts = std::string(choice.name) == "quadratic" ? 8 : 1;
    EXPECT_EQ(mesh.mesh.cells.size(), n_parts * averaged.mesh.cells.size()) << choice.name;
  }
}

} // namespace
} // namespace prosup::tests
