#include <gtest/gtest.h>

#include "program.h"

namespace prosup::tests {
namespace {

using Arguments = std::vector<std::string>;

Arguments checking(const Arguments& options) {
  Arguments arguments{"check", PROSUP_PRM_FOLDER "/tests/small.prm"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return arguments;
}

const Arguments exchanged{"--prone-image",   data_file("small/supine.nrrd"),
                          "--prone-labels",  data_file("small/supine_labels.mha"),
                          "--supine-image",  data_file("small/prone.nii.gz"),
                          "--supine-labels", data_file("small/prone_labels.nii.gz")};

TEST(Check, PassesTheSample) {
  for (const unsigned n_ranks : {1u, 2u}) {
    const ProgramRun run = run_prosup(checking({}), n_ranks);
    EXPECT_EQ(run.exit_code, 0) << run.transcript();
    EXPECT_NE(run.out.find("Nothing was found"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("chests apart, median"), std::string::npos) << run.out;
    EXPECT_EQ(run.err, "");
  }
}

TEST(Check, FindsTheWrongPosition) {
  for (const unsigned n_ranks : {1u, 2u}) {
    const ProgramRun run = run_prosup(checking(exchanged), n_ranks);
    EXPECT_EQ(run.exit_code, 1) << run.transcript();
    EXPECT_NE(run.out.find("Error: The prone breast"), std::string::npos) << run.out;
    EXPECT_EQ(without_warnings(run.err).find("prosup: The prone breast"), 0u) << run.err;
  }
}

TEST(Check, WarningsAreNoFailure) {
  const ProgramRun run =
      run_prosup(checking({"--set", "Labels/Tissues=2", "--set", "Labels/Gland=0"}));
  EXPECT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_NE(run.out.find("Warning: Section Labels does not explain label 3"), std::string::npos)
      << run.out;
}

TEST(Check, ErrorsStopARegistrationUnlessTheyAreAllowed) {
  const TemporaryFolder folder;
  Arguments arguments = checking(exchanged);
  arguments[0] = "register";
  arguments.insert(arguments.end(), {"--output", folder / "out"});
  const ProgramRun refused = run_prosup(arguments);
  EXPECT_EQ(refused.exit_code, 1) << refused.transcript();
  EXPECT_EQ(refused.out.find("Meshing"), std::string::npos) << refused.out;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  arguments.insert(arguments.end(), {"--set", "Checks/Errors stop the run=false"});
  const ProgramRun allowed = run_prosup(arguments);
  EXPECT_NE(allowed.out.find("Meshing"), std::string::npos) << allowed.transcript();
  EXPECT_NE(contents(folder / "out/summary.json").find("prone and supine are exchanged"),
            std::string::npos);
}

} // namespace
} // namespace prosup::tests
