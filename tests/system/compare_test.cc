#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "program.h"
#include "prosup/evaluation/landmarks.h"
#include "prosup/evaluation/target_registration_error.h"
#include "prosup/image/image_io.h"
#include "small_registration.h"

namespace prosup::tests {
namespace {

namespace fs = std::filesystem;

const std::string small = PROSUP_PRM_FOLDER "/tests/small.prm";

/// Arguments of `prosup compare` on the small sample.
std::vector<std::string> comparing(const fs::path& output, const std::string& runs) {
  return {"compare", small, "--output", output, "--set", "Comparison/Runs=" + runs, "--set",
          "Comparison/Title=A quick study",
          // Registered as far as it takes to have a map.
          "--set",
          "Comparison/Arguments=--set Results/Pictures=false --set \"Image forces/Levels=6\" "
          "--set \"Material update/Method=none\""};
}

/// Puts a folder on the search path, and takes it off at the end of the scope.
class SearchPath {
public:
  explicit SearchPath(const std::string& path) : before_(std::getenv("PATH")) {
    ::setenv("PATH", path.c_str(), 1);
  }
  ~SearchPath() { ::setenv("PATH", before_.c_str(), 1); }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;

private:
  const std::string before_;
};

/// A program that answers as plastimatch does, but gives every point the displacement
/// that lies in a file.
void write_stand_in(const fs::path& program, const fs::path& displacement) {
  text_file(program, "#!/bin/sh\nif [ $1 = --version ]; then echo stand-in 7; exit; fi\n"
                     "grep -q xform=bspline $2 || exit 1\n"
                     "cp '" +
                         displacement.string() + "' \"$(sed -n s/vf_out=//p $2)\"\n");
  fs::permissions(program, fs::perms::owner_all);
}

TEST(Compare, TellsSpeedAndErrorOfEachRunAndWhatFailed) {
  const TemporaryFolder folder;
  const fs::path output = folder / "study";
  const ProgramRun run = run_prosup(comparing(output, "FE/13, 10: --set \"Meshing/Edge length=$\"; "
                                                      "wrong/entry: --set Meshing/Length=3"));
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  const Json summary = read_json(output / "summary.json");
  ASSERT_EQ(summary.at("runs").size(), 3u);
  const double initial =
      evaluation::initial_error(evaluation::read_landmarks(data_file("small/landmarks.csv"))).mean;
  for (const unsigned i : {0u, 1u}) {
    const Json& one = summary.at("runs").at(i);
    EXPECT_EQ(one.at("status"), "ok");
    EXPECT_GT(one.at("time_s").get<double>(), one.at("solve_s").get<double>());
    EXPECT_LT(one.at("mean_mm").get<double>(), 0.5 * initial);
    EXPECT_GT(one.at("min_jacobian").get<double>(), 0.);
  }
  EXPECT_GT(summary.at("runs").at(1).at("cells"), summary.at("runs").at(0).at("cells"));
  const Json& failed = summary.at("runs").at(2);
  EXPECT_EQ(failed.at("status"), "failed");
  EXPECT_NE(failed.at("message").get<std::string>().find("Meshing/Length=3"), std::string::npos);
  EXPECT_FALSE(failed.contains("mean_mm"));
  const std::string table = contents(output / "study.md");
  for (const char* text : {"A quick study", "| FE | 13 | 1 |", "| failed |", "| deal.II | "})
    EXPECT_NE(table.find(text), std::string::npos) << text << "\n" << table;
  EXPECT_NE(contents(output / "study.svg").find("wall time"), std::string::npos);
  EXPECT_FALSE(fs::exists(output / "work"));
}

TEST(Compare, FailsIfAllRunsFailOrIfAllMustSucceed) {
  const TemporaryFolder folder;
  const std::string wrong = "wrong/entry: --set Meshing/Length=3";
  ProgramRun run = run_prosup(comparing(folder / "study", wrong));
  EXPECT_EQ(run.exit_code, 1) << run.transcript();
  EXPECT_NE(run.err.find("study.md"), std::string::npos) << run.err;
  EXPECT_NE(contents(folder / "study/study.md").find("Meshing/Length=3"), std::string::npos);
  auto arguments =
      comparing(folder / "study", "mesh/only: --set \"Meshing/Edge length=13\"; " + wrong);
  arguments.insert(arguments.end(), {"--set", "Comparison/All must succeed=true", "--set",
                                     "Comparison/Command=unload"});
  run = run_prosup(arguments);
  EXPECT_EQ(run.exit_code, 2) << run.transcript();
}

// A peer that moves every point by the same: its errors are known without it.
TEST(Compare, MeasuresAPeerByItsField) {
  const TemporaryFolder folder;
  const image::VoxelGrid grid = image::read_image(data_file("small/prone.nii.gz")).grid;
  image::write_displacement(image::VectorImage(grid, {2.f, -3.f, 1.f}), folder / "field.nrrd");
  fs::create_directory(folder / "bin");
  write_stand_in(folder / "bin/plastimatch", folder / "field.nrrd");
  const SearchPath path((folder / "bin").string() + ":" + std::getenv("PATH"));
  auto arguments = comparing(folder / "study", "");
  arguments.insert(arguments.end(), {"--set", "Comparison/Peers=plastimatch-bspline", "--set",
                                     "Comparison/Peer folder=" PROSUP_PRM_FOLDER "/peers", "--set",
                                     "Comparison/Repetitions=2"});
  const ProgramRun run = run_prosup(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  std::vector<double> errors;
  for (const auto& landmark : evaluation::read_landmarks(data_file("small/landmarks.csv")))
    errors.push_back(
        (landmark.prone + dealii::Tensor<1, 3>({2., -3., 1.})).distance(landmark.supine));
  const evaluation::ErrorStatistics expected = evaluation::statistics(errors);
  const Json summary = read_json(folder / "study/summary.json");
  const Json& peer = summary.at("runs").at(0);
  EXPECT_EQ(peer.at("group"), "plastimatch");
  EXPECT_NEAR(peer.at("mean_mm").get<double>(), expected.mean, 1e-4);
  EXPECT_NEAR(peer.at("max_mm").get<double>(), expected.max, 1e-4);
  EXPECT_NEAR(peer.at("min_jacobian").get<double>(), 1., 1e-6);
  EXPECT_EQ(summary.at("machine").at("plastimatch"), "stand-in 7");
}

TEST(Compare, EndsARunThatTakesTooLong) {
  const TemporaryFolder folder;
  const fs::path program =
      text_file(folder / "elastix", "#!/bin/sh\n[ \"$1\" = --version ] || exec sleep 60\n");
  fs::permissions(program, fs::perms::owner_all);
  const SearchPath path((folder / "").string() + ":" + std::getenv("PATH"));
  auto arguments = comparing(folder / "study", "");
  arguments.insert(arguments.end(), {"--set", "Comparison/Peers=elastix-bspline", "--set",
                                     "Comparison/Peer folder=" PROSUP_PRM_FOLDER "/peers", "--set",
                                     "Comparison/Time limit=1"});
  const ProgramRun run = run_prosup(arguments);
  EXPECT_EQ(run.exit_code, 1) << run.transcript();
  EXPECT_NE(contents(folder / "study/study.md").find("Comparison/Time limit"), std::string::npos);
}

TEST(Compare, NamesThePackageOfAPeerThatIsNotInstalled) {
  const TemporaryFolder folder;
  // All programs but one: MPI looks for its own there.
  fs::create_directory(folder / "bin");
  for (const auto& program : fs::directory_iterator("/usr/bin"))
    if (program.path().filename() != "elastix")
      fs::create_symlink(program.path(), folder / "bin" / program.path().filename());
  const SearchPath path(folder / "bin");
  auto arguments = comparing(folder / "study", "FE/13: ");
  arguments.insert(arguments.end(), {"--set", "Comparison/Peers=elastix-bspline"});
  const ProgramRun run = run_prosup(arguments);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err,
            "prosup: The program 'elastix' that 'Comparison/Peers' names is not installed; "
            "install Debian's package elastix, or take it out of the list.\n");
  EXPECT_FALSE(fs::exists(folder / "study"));
}

// A study runs for long; that its arguments are wrong should not be found at its end.
TEST(Compare, ShippedStudiesGiveArgumentsThatExist) {
  unsigned n_studies = 0;
  for (const auto& entry : fs::directory_iterator(PROSUP_PRM_FOLDER "/benchmarks")) {
    const std::string text = contents(entry.path());
    if (text.find("subsection Comparison") == std::string::npos)
      continue;
    ++n_studies;
    const TemporaryFolder folder;
    std::vector<std::string> arguments{"register", "--write-prm", folder / "all.prm"};
    const std::regex word("--set +(?:\"([^\"]+)\"|([^ \";]+))");
    for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at) {
      const std::string argument = (*at)[1].matched ? (*at)[1].str() : (*at)[2].str();
      if (argument.compare(0, 11, "Comparison/") == 0) // in a comment, for compare itself
        continue;
      arguments.insert(arguments.end(),
                       {"--set", std::regex_replace(argument, std::regex("\\$"), "4")});
    }
    EXPECT_GT(arguments.size(), 3u) << entry.path();
    const ProgramRun run = run_prosup(arguments);
    EXPECT_EQ(run.exit_code, 0) << entry.path() << "\n" << run.transcript();
  }
  EXPECT_GE(n_studies, 6u);
}

} // namespace
} // namespace prosup::tests
