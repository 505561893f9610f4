#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "prosup/evaluation/landmarks.h"
#include "prosup/evaluation/points.h"
#include "small_registration.h"

namespace prosup::tests {
namespace {

using dealii::Point;
using evaluation::NamedPoint;

const std::filesystem::path& registered() {
  return SmallRegistration::on_ranks(1).folder;
}

/// Positions that `prosup map` gives for `points`.
std::vector<NamedPoint> map(const std::vector<NamedPoint>& points, const std::string& from,
                            const std::string& to,
                            const std::filesystem::path& result = registered()) {
  const TemporaryFolder folder;
  evaluation::write_points(points, folder / "in.csv");
  const ProgramRun run = run_prosup({"map", "--result", result, "--from", from, "--to", to,
                                     folder / "in.csv", "-o", folder / "out.csv"});
  EXPECT_EQ(run.exit_code, 0) << run.transcript();
  return evaluation::read_points(folder / "out.csv");
}

/// The rows of a CSV file with a header, by column name.
std::vector<std::map<std::string, std::string>> read_table(const std::filesystem::path& file) {
  const auto cells = [](const std::string& line) {
    std::vector<std::string> values;
    std::istringstream stream(line);
    for (std::string value; std::getline(stream, value, ',');)
      values.push_back(value);
    return values;
  };
  std::istringstream text(contents(file));
  std::string line;
  std::getline(text, line);
  const std::vector<std::string> header = cells(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(text, line)) {
    const std::vector<std::string> values = cells(line);
    rows.emplace_back();
    for (std::size_t c = 0; c < header.size(); ++c)
      rows.back()[header[c]] = values.at(c);
  }
  return rows;
}

Point<3> position(const std::map<std::string, std::string>& row, const std::string& prefix) {
  return Point<3>(std::stod(row.at(prefix + "_x")), std::stod(row.at(prefix + "_y")),
                  std::stod(row.at(prefix + "_z")));
}

std::vector<NamedPoint> landmarks_in(const std::string& state) {
  std::vector<NamedPoint> points;
  for (const auto& landmark : evaluation::read_landmarks(data_file("small/landmarks.csv")))
    points.push_back({landmark.id, state == "prone" ? landmark.prone : landmark.supine});
  return points;
}

// The maps are exact inverses inside the meshes. A landmark that is inside one
// mesh and outside the other moves with the closest surface point, which is no
// exact inverse: hence not machine precision. 0.05 mm is a fortieth of a voxel.
TEST(Map, ThereAndBackReturns) {
  const std::vector<NamedPoint> points = landmarks_in("prone");
  const std::vector<NamedPoint> there = map(points, "prone", "supine");
  const std::vector<NamedPoint> back = map(there, "supine", "prone");
  ASSERT_EQ(back.size(), points.size());
  double moved = 0.;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(back[i].id, points[i].id);
    EXPECT_LE(back[i].position.distance(points[i].position), 0.05) << points[i].id;
    moved = std::max(moved, there[i].position.distance(points[i].position));
  }
  EXPECT_GT(moved, 10.); // mm
}

// Both files are written to 1e-6 mm.
TEST(Map, ToUnloadedGivesThePositionsOfTheLandmarkTable) {
  const auto table = read_table(registered() / "landmarks.csv");
  for (const char* state : {"prone", "supine"}) {
    const auto unloaded = map(landmarks_in(state), state, "unloaded");
    ASSERT_EQ(unloaded.size(), table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
      EXPECT_EQ(unloaded[i].id, table[i].at("id"));
      EXPECT_LE(
          unloaded[i].position.distance(position(table[i], std::string("unloaded_from_") + state)),
          1e-5)
          << state << " " << table[i].at("id");
    }
  }
}

TEST(Map, LandmarkTableAgreesWithTheSummary) {
  double sum = 0.;
  const auto table = read_table(registered() / "landmarks.csv");
  for (const auto& row : table) {
    const double distance =
        position(row, "unloaded_from_prone").distance(position(row, "unloaded_from_supine"));
    EXPECT_NEAR(distance, std::stod(row.at("tre_mm")), 1e-4) << row.at("id");
    sum += distance;
  }
  const Json& tre = SmallRegistration::on_ranks(1).summary.at("tre").at("image_forces");
  EXPECT_EQ(table.size(), tre.at("n").get<std::size_t>());
  EXPECT_NEAR(sum / static_cast<double>(table.size()), tre.at("mean").get<double>(), 1e-4);
}

// A registration is worth something if its map beats no map.
TEST(Map, ProneLandmarksLandNearTheirSupinePartners) {
  const auto mapped = map(landmarks_in("prone"), "prone", "supine");
  const auto truth = landmarks_in("supine"), start = landmarks_in("prone");
  double error = 0., initial = 0.;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    error += mapped[i].position.distance(truth[i].position);
    initial += start[i].position.distance(truth[i].position);
  }
  EXPECT_LT(error, 0.4 * initial);
}

// One file is enough, and so are the files of versions that wrote no HDF5. VTU and HDF5 hold the
// same bits.
TEST(Map, FromTheHdf5FileAloneAndFromVtuFilesIsTheSame) {
  const TemporaryFolder folder;
  std::filesystem::copy(registered() / "registration.h5", folder / "only.h5");
  std::filesystem::create_directory(folder / "old");
  for (const char* name : {"summary.json", "prone_loaded.vtu", "supine_loaded.vtu"})
    std::filesystem::copy(registered() / name, folder / "old" / name);
  const auto points = landmarks_in("prone");
  const auto expected = map(points, "prone", "supine");
  for (const std::filesystem::path& result : {folder / "only.h5", folder / "old"}) {
    const auto found = map(points, "prone", "supine", result);
    ASSERT_EQ(found.size(), expected.size()) << result;
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_EQ(found[i].position, expected[i].position) << result;
  }
}

TEST(Map, FromADamagedHdf5FileIsRefused) {
  const TemporaryFolder folder;
  std::filesystem::copy(registered() / "registration.h5", folder / "bad.h5");
  std::filesystem::resize_file(folder / "bad.h5", 10000);
  evaluation::write_points(landmarks_in("prone"), folder / "in.csv");
  const ProgramRun run =
      run_prosup({"map", "--result", folder / "bad.h5", "--from", "prone", "--to", "supine",
                  folder / "in.csv", "-o", folder / "out.csv"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("bad.h5' is damaged"), std::string::npos) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
}

TEST(Map, ToTheSameStateIsTheIdentity) {
  const std::vector<NamedPoint> points = landmarks_in("supine");
  const std::vector<NamedPoint> same = map(points, "supine", "supine");
  ASSERT_EQ(same.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LE(same[i].position.distance(points[i].position), 1e-5) << points[i].id;
}

// All points have error bars; they are neither nothing nor the size of the breast.
TEST(Map, WritesHowSureThePointsAre) {
  const TemporaryFolder folder;
  evaluation::write_points(landmarks_in("prone"), folder / "in.csv");
  for (const char* to : {"supine", "unloaded"}) {
    const ProgramRun run = run_prosup({"map", "--result", registered(), "--from", "prone", "--to",
                                       to, folder / "in.csv", "-o", folder / "out.csv"});
    ASSERT_EQ(run.exit_code, 0) << run.transcript();
    const auto rows = read_table(folder / "out.csv");
    ASSERT_EQ(rows.size(), landmarks_in("prone").size());
    for (const auto& row : rows) {
      const double radius = std::stod(row.at("radius_95"));
      double largest = 0.;
      for (const char* axis : {"sd_x", "sd_y", "sd_z"}) {
        const double deviation = std::stod(row.at(axis));
        EXPECT_GT(deviation, 0.) << row.at("id");
        largest = std::max(largest, deviation);
      }
      EXPECT_GT(radius, 1.9 * largest) << row.at("id");
      EXPECT_LT(radius, 2.9 * std::sqrt(3.) * largest) << row.at("id");
      EXPECT_GT(radius, 0.02) << row.at("id");
      EXPECT_LT(radius, 15.) << row.at("id");
    }
  }
}

// Of what 3D Slicer wrote, positions change and names, colours and coordinate system stay.
TEST(Map, AnswersInTheFormatOfThePoints) {
  const TemporaryFolder folder;
  const NamedPoint point = landmarks_in("prone").front();
  const Json asked{
      {"markups",
       {{{"type", "Fiducial"},
         {"coordinateSystem", "RAS"},
         {"display", {{"color", {0.2, 0.4, 0.6}}}},
         {"controlPoints",
          {{{"id", "1"},
            {"label", "lesion"},
            {"position", {-point.position[0], -point.position[1], point.position[2]}}}}}}}}};
  text_file(folder / "in.mrk.json", asked.dump());
  const Point<3> expected = map({point}, "prone", "supine").front().position;
  for (const char* name : {"out.mrk.json", "out.fcsv", "out.csv"}) {
    const ProgramRun run = run_prosup({"map", "--result", registered(), "--from", "prone", "--to",
                                       "supine", folder / "in.mrk.json", "-o", folder / name});
    ASSERT_EQ(run.exit_code, 0) << run.transcript();
    const auto points = evaluation::read_points(folder / name);
    ASSERT_EQ(points.size(), 1u) << name;
    EXPECT_EQ(points[0].id, "lesion") << name;
    EXPECT_LT(points[0].position.distance(expected), 2e-6) << name;
  }
  const Json answer = read_json(folder / "out.mrk.json").at("markups").at(0);
  EXPECT_EQ(answer.at("coordinateSystem"), "RAS");
  EXPECT_EQ(answer.at("display"), asked.at("markups").at(0).at("display"));
}

// Landmarks lie in the breast: between skin and chest wall, in tissue that hardly changes volume
// but for single cells of the coarse mesh.
TEST(Map, TellsWhereThePointsAreInTheBreast) {
  const TemporaryFolder folder;
  evaluation::write_points(landmarks_in("prone"), folder / "in.csv");
  const ProgramRun run = run_prosup({"map", "--result", registered(), "--from", "prone", "--to",
                                     "supine", folder / "in.csv", "-o", folder / "out.csv"});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  const auto rows = read_table(folder / "out.csv");
  double mean = 0.;
  for (const auto& row : rows) {
    const double J = std::stod(row.at("J"));
    EXPECT_GT(J, 0.2) << row.at("id");
    EXPECT_LT(J, 4.) << row.at("id");
    mean += J / double(rows.size());
    EXPECT_LT(std::stod(row.at("outside")), 2.) << row.at("id");
    for (const char* column : {"skin_before", "chest_before", "skin_after", "chest_after"}) {
      EXPECT_GT(std::stod(row.at(column)), 0.) << row.at("id") << " " << column;
      EXPECT_LT(std::stod(row.at(column)), 120.) << row.at("id") << " " << column;
    }
  }
  EXPECT_NEAR(mean, 1., 0.15);
}

// Given once, the nipple of the other state is where it is mapped to; the point itself has no
// distance from it.
TEST(Map, TellsTheDistanceFromTheNipple) {
  const TemporaryFolder folder;
  std::vector<NamedPoint> points = landmarks_in("prone");
  points.resize(2);
  evaluation::write_points(points, folder / "in.csv");
  const auto rows = [&](const std::string& nipple, const std::string& message) {
    std::vector<std::string> arguments{
        "map",  "--result", registered(),      "--from", "prone",
        "--to", "supine",   folder / "in.csv", "-o",     folder / "out.csv"};
    if (!nipple.empty())
      arguments.insert(arguments.begin() + 1, {"--prone-nipple", nipple});
    const ProgramRun run = run_prosup(arguments);
    EXPECT_EQ(run.exit_code, message.find("LPS, mm.") == std::string::npos ? 0 : 1)
        << run.transcript();
    EXPECT_NE((run.out + run.err).find(message), std::string::npos) << run.transcript();
    return read_table(folder / "out.csv");
  };
  const auto found = rows("", "The nipple is taken to be");
  // On the skin in front, of a breast that hangs some 70 mm and is 140 mm wide.
  for (const char* column : {"nipple_before", "nipple_after"}) {
    EXPECT_GT(std::stod(found[0].at(column)), 1.) << column;
    EXPECT_LT(std::stod(found[0].at(column)), 120.) << column;
  }
  const Point<3> x = points[1].position;
  const auto given = rows(format("%.6f,%.6f,%.6f", x[0], x[1], x[2]), "");
  EXPECT_NEAR(std::stod(given[1].at("nipple_before")), 0., 1e-5);
  EXPECT_NEAR(std::stod(given[1].at("nipple_after")), 0., 1e-5);
  EXPECT_NEAR(std::stod(given[0].at("nipple_before")), points[0].position.distance(x), 1e-5);
  rows("0,0,500", "mm can be; give it in LPS, mm.");
  rows("0,-70,nan", "'0,-70,nan' and not three finite numbers; give X,Y,Z in LPS, mm.");
}

// A point that is outside of both meshes is one point.
TEST(Map, CountsAndNamesThePointsOutside) {
  const TemporaryFolder folder;
  std::vector<NamedPoint> points = landmarks_in("prone");
  points.resize(2);
  points.push_back({"in the air", points[0].position + dealii::Tensor<1, 3>({0., 0., 500.})});
  evaluation::write_points(points, folder / "in.csv");
  const ProgramRun run = run_prosup({"map", "--result", registered(), "--from", "prone", "--to",
                                     "supine", folder / "in.csv", "-o", folder / "out.csv"});
  ASSERT_EQ(run.exit_code, 0) << run.transcript();
  EXPECT_NE((run.out + run.err).find("1 of 3 points lie more than 2 mm outside"), std::string::npos)
      << run.transcript();
  EXPECT_NE((run.out + run.err).find("('in the air')"), std::string::npos) << run.transcript();
  const auto rows = read_table(folder / "out.csv");
  EXPECT_GT(std::stod(rows[2].at("outside")), 100.);
  EXPECT_EQ(rows[2].at("radius_95"), ""); // nothing is known of it
  EXPECT_GT(std::stod(rows[0].at("radius_95")), 0.);
}

// The sample has few landmarks; a model that has lost its scale misses most of them or none by far.
TEST(Map, ErrorBarsHoldTheLandmarksOfTheSample) {
  const auto rows = read_table(registered() / "landmarks.csv");
  std::vector<double> errors, radii;
  std::size_t n_within = 0;
  for (const auto& row : rows) {
    errors.push_back(std::stod(row.at("tre_mm")));
    radii.push_back(std::stod(row.at("radius_95")));
    n_within += errors.back() < radii.back();
  }
  std::sort(errors.begin(), errors.end());
  std::sort(radii.begin(), radii.end());
  const std::size_t middle = rows.size() / 2;
  EXPECT_GE(double(n_within), 0.6 * double(rows.size()));
  EXPECT_LT(radii[middle], 8. * errors[middle]);
  EXPECT_TRUE(std::filesystem::is_regular_file(registered() / "unloaded_radius_95.nii.gz"));
}

} // namespace
} // namespace prosup::tests
