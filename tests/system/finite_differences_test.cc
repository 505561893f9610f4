#include "small_registration.h"

namespace prosup::tests {
namespace {

double mean_error(const Json& summary, const char* row) {
  return summary.at("tre").at(row).at("mean").get<double>();
}

// As `prosup register prm/tests/small.prm`, by the paper's method.
TEST(FiniteDifferences, RegisterBringsTheLandmarksTogether) {
  double error_on_one_rank = 0.;
  for (const unsigned n_ranks : {1u, 2u}) {
    const TemporaryFolder folder;
    const ProgramRun run = run_prosup({"register", PROSUP_PRM_FOLDER "/tests/small.prm", "--method",
                                       "fdm", "--output", folder / "result"},
                                      n_ranks);
    ASSERT_EQ(run.exit_code, 0) << run.transcript();
    const Json summary = read_json(folder / "result" / "summary.json");
    EXPECT_TRUE(summary.at("converged").get<bool>());
    EXPECT_LT(mean_error(summary, "unloaded"), 0.5 * mean_error(summary, "initial"));
    EXPECT_LT(mean_error(summary, "material"), mean_error(summary, "unloaded"));
    EXPECT_LT(mean_error(summary, "image_forces"), 0.8 * mean_error(summary, "material"));
    const double error = mean_error(summary, "image_forces");
    if (n_ranks == 1)
      error_on_one_rank = error;
    else
      EXPECT_NEAR(error, error_on_one_rank, 0.02); // mm
    EXPECT_GT(summary.at("min_jacobian").at("prone").get<double>(), 0.);
    for (const char* file : {"prone_to_supine.nrrd", "prone_unloaded.nii.gz", "prone.pvd"})
      EXPECT_TRUE(std::filesystem::exists(folder / "result" / file)) << file;
  }
}

TEST(FiniteDifferences, UnloadFindsTheTruth) {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_prosup({"unload", PROSUP_PRM_FOLDER "/tests/small.prm", "--method", "fdm", "--output",
                  folder / "result", "--set", "Material/Shear modulus=150", "--set",
                  "Material/Poisson ratio=0.45", "--set", "Material/Stiffness ratios=2:1, 3:3"},
                 1);
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  const Json summary = read_json(folder / "result" / "summary.json");
  EXPECT_TRUE(summary.at("converged").get<bool>());
  EXPECT_LT(mean_error(summary, "unloaded"), 1.5); // mm; the landmarks move by more than 5
}

TEST(FiniteDifferences, LoadIsForFiniteElements) {
  const TemporaryFolder folder;
  const ProgramRun run = run_prosup({"load", PROSUP_PRM_FOLDER "/tests/small.prm", "--method",
                                     "fdm", "--output", folder / "result"},
                                    1);
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.transcript().find("--method fe"), std::string::npos) << run.transcript();
  EXPECT_FALSE(std::filesystem::exists(folder / "result"));
}

} // namespace
} // namespace prosup::tests
