#include "prosup/evaluation/landmarks.h"

#include "prosup/evaluation/landmarks_csv.h"
#include "small_registration.h"

namespace prosup::tests {
namespace {

// The control observer agrees to 3 mm but for one landmark that is 20 mm away.
TEST(Landmarks, ControlObserverOfAFinishedRegistration) {
  const auto& registered = SmallRegistration::on_ranks(1);
  const TemporaryFolder folder;
  auto picked = evaluation::read_landmarks(data_file("small/landmarks.csv"));
  for (auto& landmark : picked)
    landmark.supine[2] += landmark.id == picked[1].id ? 20. : 3.;
  evaluation::write_landmarks(picked, folder / "control.csv");
  const ProgramRun run =
      run_prosup({"landmarks", "--result", registered.folder, data_file("small/landmarks.csv"),
                  "--control", folder / "control.csv", "-o", folder / "out.csv"});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_NE(run.out.find("| landmarks - control | supine | 3.1 | 20.0 |"), std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("not reliable: " + picked[1].id + "\n"), std::string::npos) << run.out;
  const std::string table = contents(folder / "out.csv");
  const Json& tre = registered.summary.at("tre").at("image_forces");
  char expected[200];
  std::snprintf(expected, sizeof expected, "registration_error,landmarks,all,%zu,%.2f",
                picked.size(), tre.at("mean").get<double>());
  EXPECT_NE(table.find(expected), std::string::npos) << table << expected;
}

TEST(Landmarks, RefusesAFolderWithoutResult) {
  const TemporaryFolder folder;
  const ProgramRun run = run_prosup({"landmarks", "--result", folder / "none",
                                     data_file("small/landmarks.csv"), "-o", folder / "out.csv"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("no finished registration"), std::string::npos) << run.transcript();
}

} // namespace
} // namespace prosup::tests
