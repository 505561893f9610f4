#include <cmath>

#include "prosup/evaluation/landmarks.h"
#include "prosup/evaluation/points.h"
#include "prosup/image/image_io.h"
#include "prosup/output/displacement_fields.h"
#include "small_registration.h"

namespace prosup::tests {
namespace {

using dealii::Point;
using dealii::Tensor;

const std::filesystem::path& registered() {
  return SmallRegistration::on_ranks(1).folder;
}

/// The arguments of a run from one state to another.
std::vector<std::string> carrying(const std::string& from, const std::string& to,
                                  const std::string& input, const std::string& output) {
  return {"warp", "--result", registered(), "--from", from, "--to", to, input, "-o", output};
}

ProgramRun warp(const std::string& from, const std::string& to, const std::string& input,
                const std::string& output, const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments = carrying(from, to, input, output);
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ProgramRun run = run_prosup(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.transcript();
  return run;
}

double mean_difference(const image::ScalarImage& a, const image::ScalarImage& b,
                       const image::LabelImage& where) {
  double sum = 0., n = 0.;
  for (std::size_t v = 0; v < a.values.size(); ++v)
    if (where.values[v] != 0) {
      sum += std::abs(double(a.values[v]) - double(b.values[v]));
      n += 1.;
    }
  return sum / n;
}

// What register writes of the other state is what warp makes of the image, but for its rounding.
TEST(Warp, CarriesImagesToTheOtherState) {
  const TemporaryFolder folder;
  warp("prone", "supine", data_file("small/prone.nii.gz"), folder / "out.nii.gz");
  const auto warped = image::read_image(folder / "out.nii.gz"),
             expected = image::read_image(registered() / "prone_in_supine.nii.gz"),
             supine = image::read_image(data_file("small/supine.nrrd")),
             prone = image::read_image(data_file("small/prone.nii.gz"));
  const auto valid = image::read_labels(registered() / "valid_supine.nii.gz");
  ASSERT_TRUE(warped.grid.coincides_with(supine.grid));
  EXPECT_LT(mean_difference(warped, expected, image::LabelImage(warped.grid, 1)), 0.5);
  // Registered images are alike: much more so than by chance.
  const image::ScalarImage flat(supine.grid, supine.values[0]);
  EXPECT_LT(mean_difference(warped, supine, valid), 0.2 * mean_difference(flat, supine, valid));
}

TEST(Warp, CarriesLabelsAsLabelsAndLeavesTheChest) {
  const TemporaryFolder folder;
  const ProgramRun run =
      warp("prone", "supine", data_file("small/prone_labels.nii.gz"), folder / "out.nrrd");
  EXPECT_NE((run.out + run.err).find("mark regions"), std::string::npos) << run.transcript();
  const auto warped = image::read_labels(folder / "out.nrrd"),
             truth = image::read_labels(data_file("small/supine_labels.mha"));
  double breast = 0., both = 0., chest = 0., same_chest = 0.;
  for (std::size_t v = 0; v < truth.values.size(); ++v) {
    const bool here = warped.values[v] > 1, there = truth.values[v] > 1;
    breast += double(here) + double(there);
    both += 2. * double(here && there);
    chest += double(warped.values[v] == 1) + double(truth.values[v] == 1);
    same_chest += 2. * double(warped.values[v] == 1 && truth.values[v] == 1);
  }
  EXPECT_GT(both / breast, 0.93);
  EXPECT_GT(same_chest / chest, 0.93);
}

// Also from the unloaded state, whose fields are computed, and on another grid.
TEST(Warp, ThereAndBackReturns) {
  const TemporaryFolder folder;
  const std::string prone = data_file("small/prone.nii.gz");
  warp("prone", "unloaded", prone, folder / "unloaded.mha");
  warp("unloaded", "prone", folder / "unloaded.mha", folder / "back.mha", {"--like", prone});
  const auto original = image::read_image(prone), back = image::read_image(folder / "back.mha");
  ASSERT_TRUE(back.grid.coincides_with(original.grid));
  const auto valid = image::read_labels(registered() / "valid_prone.nii.gz");
  const image::ScalarImage flat(original.grid, original.values[0]);
  EXPECT_LT(mean_difference(back, original, valid), 0.2 * mean_difference(flat, original, valid));
}

// A model goes where map takes its points, and a model of the chest stays.
TEST(Warp, CarriesModelsLikePoints) {
  const TemporaryFolder folder;
  const auto landmark = evaluation::read_landmarks(data_file("small/landmarks.csv")).front();
  std::string model;
  std::vector<evaluation::NamedPoint> points;
  for (unsigned corner = 0; corner < 4; ++corner) {
    Point<3> p = landmark.prone;
    if (corner > 0)
      p[corner - 1] += 1.;
    points.push_back({std::to_string(corner), p});
    model += format("v %.9g %.9g %.9g\n", p[0], p[1], p[2]);
  }
  text_file(folder / "in.obj", model + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  warp("prone", "supine", folder / "in.obj", folder / "out.obj");
  evaluation::write_points(points, folder / "in.csv");
  const ProgramRun run = run_prosup({"map", "--result", registered(), "--from", "prone", "--to",
                                     "supine", folder / "in.csv", "-o", folder / "out.csv"});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  const auto mapped = evaluation::read_points(folder / "out.csv");
  std::istringstream text(contents(folder / "out.obj"));
  std::size_t n = 0;
  for (std::string word; text >> word;)
    if (word == "v") {
      Point<3> p;
      text >> p[0] >> p[1] >> p[2];
      ASSERT_LT(n, mapped.size());
      EXPECT_LT(p.distance(mapped[n++].position), 1e-2);
    }
  EXPECT_EQ(n, 4u);
}

// A field is what warp carries by: the result's own, or that to the unloaded state, which is
// computed.
TEST(Field, IsGivenToOtherPrograms) {
  const TemporaryFolder folder;
  const auto field = [&](const char* to, const std::string& name, const std::string& message) {
    const ProgramRun run =
        run_prosup({"field", "--result", registered(), "--from", "prone", "--to", to, "--like",
                    data_file("small/prone.nii.gz"), "-o", folder / name});
    EXPECT_EQ(run.exit_code, message.empty() ? 0 : 1) << run.transcript();
    EXPECT_NE(run.err.find(message), std::string::npos) << run.transcript();
  };
  field("supine", "field.mha", "");
  const auto found = image::read_displacement(folder / "field.mha"),
             expected = image::read_displacement(registered() / "prone_to_supine.nrrd");
  ASSERT_TRUE(found.grid.coincides_with(expected.grid));
  for (std::size_t v = 0; v < found.values.size(); ++v)
    for (unsigned d = 0; d < 3; ++d)
      ASSERT_NEAR(found.values[v][d], expected.values[v][d], 1e-4) << v; // mm
  field("unloaded", "field.h5", "");
  EXPECT_EQ(contents(folder / "field.h5").substr(1, 3), "HDF");
  field("prone", "same.h5", "both 'prone'");
  field("supine", "field.nii.gz", "field.nii.gz");
  EXPECT_FALSE(std::filesystem::exists(folder / "field.nii.gz"));
}

// On an oblique grid of other voxels the field is in the mesh that of `map` at the voxels.
TEST(Field, OnAnotherGridIsThatOfMap) {
  const TemporaryFolder folder;
  image::LabelImage valid = image::read_labels(registered() / "valid_prone.nii.gz");
  image::ScalarImage oblique{image::VoxelGrid(valid.grid)};
  image::VoxelGrid& grid = oblique.grid;
  const double c = std::cos(0.3), s = std::sin(0.3);
  grid.direction = Tensor<2, 3>({{c, -s, 0.}, {s, c, 0.}, {0., 0., 1.}});
  grid.spacing = Tensor<1, 3>({3.1, 4.3, 5.7});
  grid.size = {30, 20, 20};
  const Point<3> middle =
      valid.grid.physical(0.5 * double(valid.grid.size[0]), 0.5 * double(valid.grid.size[1]),
                          0.5 * double(valid.grid.size[2]));
  grid.origin += middle - grid.physical(15., 10., 10.);
  oblique = image::ScalarImage(grid);
  image::write_image(oblique, folder / "like.mha");
  ProgramRun run =
      run_prosup({"field", "--result", registered(), "--from", "prone", "--to", "supine", "--like",
                  folder / "like.mha", "-o", folder / "field.mha"});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  const auto field = image::read_displacement(folder / "field.mha");

  // Voxels all of whose surroundings of 4 mm are in the breast.
  const auto in_breast = [&, sampler = output::voxels_with(valid, 1)](const Point<3>& x) {
    for (unsigned d = 0; d < 3; ++d)
      for (const double step : {-4., 4.}) {
        Point<3> beside = x;
        beside[d] += step;
        if (!sampler(beside))
          return false;
      }
    return true;
  };
  std::vector<evaluation::NamedPoint> points, expected;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i) {
        const Point<3> x = field.grid.physical(double(i), double(j), double(k));
        if (!in_breast(x))
          continue;
        const std::string name = std::to_string(points.size());
        const auto& u = field(i, j, k);
        points.push_back({name, x});
        expected.push_back({name, x + Tensor<1, 3>({u[0], u[1], u[2]})});
      }
  ASSERT_GT(points.size(), 200u);
  evaluation::write_points(points, folder / "in.csv");
  run = run_prosup({"map", "--result", registered(), "--from", "prone", "--to", "supine",
                    folder / "in.csv", "-o", folder / "out.csv"});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  const auto mapped = evaluation::read_points(folder / "out.csv");
  for (std::size_t n = 0; n < mapped.size(); ++n)
    ASSERT_LT(mapped[n].position.distance(expected[n].position), 5e-3) << n; // mm
}

TEST(Warp, WrongUseIsRefused) {
  const TemporaryFolder folder;
  const std::string prone = data_file("small/prone.nii.gz");
  text_file(folder / "m.obj", "v 0 0 0\n");
  const auto expect_refused = [&](std::vector<std::string> arguments, const std::string& message) {
    const ProgramRun run = run_prosup(arguments);
    EXPECT_EQ(run.exit_code, 1) << run.transcript();
    EXPECT_NE(run.err.find(message), std::string::npos) << run.transcript();
  };
  const auto with = [](std::vector<std::string> arguments, const std::string& option) {
    arguments.push_back(option);
    return arguments;
  };
  expect_refused(carrying("prone", "prone", prone, folder / "o.mha"), "both 'prone'");
  expect_refused(carrying("prone", "supine", prone, folder / "o.png"), "o.png");
  expect_refused(carrying("prone", "supine", prone, folder / "o.stl"), "a model and an image");
  expect_refused(with(carrying("prone", "supine", folder / "m.obj", folder / "o.stl"), "--labels"),
                 "are for images");
  expect_refused(carrying("prone", "supine", folder / "no.mha", folder / "o.mha"), "no.mha");
  std::filesystem::copy(prone, folder / "in.nii.gz");
  expect_refused(
      with(carrying("prone", "supine", folder / "in.nii.gz", folder / "in.nii.gz"), "--overwrite"),
      "is the input");
  std::vector<std::string> alone = carrying("prone", "supine", prone, folder / "o.mha");
  alone[2] = registered() / "registration.h5";
  expect_refused(alone, "is no folder");
  EXPECT_FALSE(std::filesystem::exists(folder / "o.mha"));
}

} // namespace
} // namespace prosup::tests
