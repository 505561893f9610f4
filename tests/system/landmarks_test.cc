#include "prosup/evaluation/landmarks.h"

#include <functional>

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
                picked.size(), std::floor(100. * tre.at("mean").get<double>()) / 100.);
  EXPECT_NE(table.find(expected), std::string::npos) << table << expected;
}

// In RAS, in metres, with prone and supine exchanged: the registration goes on, but says so.
TEST(Landmarks, ThatLieElsewhereAreReported) {
  EXPECT_TRUE(SmallRegistration::on_ranks(1).summary.at("warnings").empty());
  const auto landmarks = evaluation::read_landmarks(data_file("small/landmarks.csv"));
  const TemporaryFolder folder;
  const std::vector<std::function<void(evaluation::Landmark&)>> mistakes{
      [](auto& l) {
        for (auto* x : {&l.prone, &l.supine})
          *x = dealii::Point<3>(-(*x)[0], -(*x)[1], (*x)[2]);
      },
      [](auto& l) {
        l.prone /= 1000.;
        l.supine /= 1000.;
      },
      [](auto& l) { std::swap(l.prone, l.supine); }};
  for (const auto& mistake : mistakes) {
    auto wrong = landmarks;
    for (auto& landmark : wrong)
      mistake(landmark);
    evaluation::write_landmarks(wrong, folder / "wrong.csv");
    const ProgramRun run = run_prosup(
        {"register", PROSUP_PRM_FOLDER "/tests/small.prm", "--landmarks", folder / "wrong.csv",
         "--set", "Material update/Method=none", "--set", "Image forces/Levels=6", "--set",
         "Image forces/Updates per level=1", "--output", folder / "out"});
    ASSERT_EQ(run.exit_code, 0) << run.transcript();
    const Json warnings = read_json(folder / "out/summary.json").at("warnings");
    const std::string text = warnings.dump();
    EXPECT_TRUE(text.find("landmarks lie more than 5 mm outside") != std::string::npos ||
                text.find("of each other; check that they are positions in mm") !=
                    std::string::npos)
        << text;
  }
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
