#include "prosup/output/report.h"

#include <deal.II/base/utilities.h>
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cmath>
#include <fstream>

#include "affine_mesh.h"
#include "expect_error.h"
#include "prosup/core/log.h"
#include "prosup/image/image_io.h"
#include "prosup/output/registration_file.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::output;

const char* const summary = R"({"version": "7.8.9", "command": "register", "ranks": 2,
  "metric": "lncc", "peak_memory": 512.0,
  "quality": {"verdict": "doubtful", "reasons": ["The <skin> is 5 mm apart & so on."],
  "unloaded": {"breast_dice": 0.5, "gland_dice": 0.5, "volume_ratio": 2},
  "image_forces": {"breast_dice": 0.975, "gland_dice": 0.81, "volume_ratio": 1.01}},
  "warnings": ["Something was assumed."],
  "tre": {"initial": {"mean": 10.5, "std": 1, "p95": 12, "max": 20, "n": 2},
          "image_forces": {"mean": 0.75, "std": 0.5, "p95": 1, "max": 1.25, "n": 2}},
  "time": {"mesh": 1.5, "total": 20.0},
  "similarity": [{"stage": "material", "level_mm": 6.0, "iteration": 0, "value": 200.0},
                 {"stage": "material", "level_mm": 6.0, "iteration": 1, "value": 100.0},
                 {"stage": "image_forces", "level_mm": 2.0, "iteration": 0, "value": 400.0},
                 {"stage": "image_forces", "level_mm": 2.0, "iteration": 1, "value": 200.0}]})";
const char* const used = "subsection Case\n  set Prone image = /data/prone.nii.gz # default: \n"
                         "  set Prone gravity = 0, -1, 0\nend\n"
                         "subsection Image forces\n  subsection Accumulated\n"
                         "    set Ramp = 5 # default: 3\n    set Other = 1\n  end\nend\n";

class Report : public ::testing::Test {
protected:
  Report() {
    text_file(folder_ / "summary.json", summary);
    text_file(folder_ / "used.prm", used);
    text_file(folder_ / "landmarks.csv", "id,prone_x,tre_mm\nfirst,1,0.25\nworst,2,1.25\n");
    image::VoxelGrid grid;
    grid.size = {40, 30, 20};
    grid.spacing = dealii::Tensor<1, 3>({2., 2., 2.});
    for (const Position position : both_positions) {
      images_[position] = image::ScalarImage(grid);
      masks_[position] = image::LabelImage(grid);
      for (std::size_t v = 0; v < grid.n_voxels(); ++v) {
        images_[position].values[v] = float(v % 37);
        masks_[position].values[v] = v % 40 > 25;
      }
      shown_.images[position] = &images_[position];
      shown_.masks[position] = &masks_[position];
    }
    image::write_image(images_.prone, folder_ / "prone_in_supine.nii.gz");
  }

  std::string page(const std::optional<ReportImages>& images) const {
    write_report(folder_ / "", {{"Shear modulus", "300 Pa", "searched from 10 to 1000 Pa"}},
                 images);
    return contents(folder_ / report_html);
  }

  const TemporaryFolder folder_;
  PerPosition<image::ScalarImage> images_;
  PerPosition<image::LabelImage> masks_;
  ReportImages shown_;
};

/// What stands between `start` and `end`, at each place.
std::vector<std::string> between(const std::string& text, const std::string& start,
                                 const std::string& end) {
  std::vector<std::string> found;
  for (std::size_t at = 0; (at = text.find(start, at)) != std::string::npos;) {
    at += start.size();
    found.push_back(text.substr(at, text.find(end, at) - at));
  }
  return found;
}

bool is_picture(const std::string& uri) {
  const std::string type = "data:image/png;base64,";
  if (uri.compare(0, type.size(), type) != 0)
    return false;
  const auto bytes = dealii::Utilities::decode_base64(uri.substr(type.size()));
  const TemporaryFolder folder;
  std::ofstream(folder / "a.png", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((folder / "a.png").c_str());
  reader->Update();
  return reader->GetErrorCode() == 0 && reader->GetOutput()->GetDimensions()[0] > 100;
}

TEST_F(Report, NeedsNothingFromElsewhereAndAllPicturesDecode) {
  const std::string html = page(shown_);
  const auto sources = between(html, "src=\"", "\"");
  EXPECT_EQ(sources.size(), 12u); // three planes: supine, and prone in three ways
  for (const std::string& source : sources)
    EXPECT_TRUE(is_picture(source)) << source.substr(0, 40);
  for (const char* reference : {"href=", "url(", "@import", "fetch(", "XMLHttpRequest", "<link",
                                "<iframe", "<object", "script src"})
    EXPECT_EQ(html.find(reference), std::string::npos) << reference;
  for (const std::string& address : between(html, "http", "\""))
    EXPECT_EQ(address, "://www.w3.org/2000/svg"); // a name, not fetched
}

// The mask of prone is seen as it lies, and carried to supine by the field.
TEST_F(Report, PronePicturesHaveTheOutlineOfTheProneBreast) {
  image::VectorImage field(images_.prone.grid);
  image::write_displacement(field, folder_ / "supine_to_prone.nrrd");
  const auto prone_pictures = [&] {
    auto sources = between(page(shown_), "src=\"", "\"");
    EXPECT_EQ(sources.size(), 12u);
    sources.resize(4); // of the axial plane: supine, prone carried, as scanned, checkerboard
    return sources;
  };
  const auto same = prone_pictures();
  for (std::size_t v = 0; v < masks_.prone.values.size(); ++v)
    masks_.prone.values[v] = v % 40 > 20;
  const auto larger = prone_pictures();
  EXPECT_EQ(larger[0], same[0]);
  for (std::size_t n = 1; n < 4; ++n)
    EXPECT_NE(larger[n], same[n]) << n;
  // The field takes the outline of supine to that of prone.
  for (auto& u : field.values)
    u = {-10.f, 0.f, 0.f};
  image::write_displacement(field, folder_ / "supine_to_prone.nrrd");
  const auto carried = prone_pictures();
  EXPECT_EQ(carried[1], same[1]);
  EXPECT_EQ(carried[2], larger[2]);
  EXPECT_EQ(carried[3], same[3]);
}

TEST_F(Report, ElementsAreClosed) {
  const std::string html = page(shown_);
  for (const char* element : {"html", "head", "body", "section", "table", "tr", "td", "figure",
                              "div", "ul", "li", "svg", "style", "script", "p", "label"}) {
    const std::string name = element;
    const auto n_opened =
        between(html, "<" + name + ">", "").size() + between(html, "<" + name + " ", "").size();
    EXPECT_EQ(n_opened, between(html, "</" + name + ">", "").size()) << name;
  }
}

TEST_F(Report, SaysWhatWasFound) {
  const std::string html = page(shown_);
  EXPECT_LT(html.find("Verdict: doubtful"), html.find("<section>")); // on top
  for (const char* part :
       {"The &lt;skin&gt; is 5 mm apart &amp; so on.", "Something was assumed.", "prosup 7.8.9",
        "/data/prone.nii.gz", "0, -1, 0", "0.75", "1.25", "worst", "300 Pa",
        "searched from 10 to 1000 Pa", "Image forces/Accumulated/Ramp", "default: 3", "prosup warp",
        "to the left of the middle", "512 MiB", "look at the reasons and the pictures before",
        "The outlines overlap by 97.5 %, the glands by 81 %", "0.75 mm apart on average",
        "0, -1, 0 (direction, LPS)"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_EQ(html.find("Accumulated/Other"), std::string::npos); // as by default
}

// In affine maps of a box J is the same everywhere: det A of supine over that of prone.
TEST_F(Report, ShowsTheDeformation) {
  const mesh::TetMesh box = box_of_tets({52., 15., 10.}, {72., 45., 30.}, 2);
  const AffineMap to_prone = stretch_and_shear(), to_supine = other_stretch_and_shear();
  write_registration({affine_mesh(box, to_prone), affine_mesh(box, to_supine)}, {}, folder_ / "");
  const std::string html = page(shown_);
  const auto sources = between(html, "src=\"", "\"");
  ASSERT_EQ(sources.size(), 18u); // and two maps of three planes
  for (const std::string& source : sources)
    EXPECT_TRUE(is_picture(source)) << source.substr(0, 40);
  const double J = determinant(to_supine.A) / determinant(to_prone.A);
  EXPECT_NE(html.find(format("J is %.2f on the median, and 90 %% lie from %.2f to %.2f", J, J, J)),
            std::string::npos);
  EXPECT_NE(html.find("aria-label=\"Displacement from prone to supine relative to the chest, mm"),
            std::string::npos);
}

// The dot is where the supine image has the landmark; 10 mm of the box are 30 pixels, and the error
// of 0.5 mm is drawn 20 times as long.
TEST_F(Report, ShowsErrorsAsVectors) {
  const mesh::TetMesh box = box_of_tets({52., 15., 10.}, {72., 45., 30.}, 2);
  const AffineMap to_prone = stretch_and_shear(), to_supine = other_stretch_and_shear();
  write_registration({affine_mesh(box, to_prone), affine_mesh(box, to_supine)}, {}, folder_ / "");
  text_file(folder_ / "landmarks.csv",
            "id,unloaded_from_prone_x,unloaded_from_prone_y,unloaded_from_prone_z,"
            "unloaded_from_supine_x,unloaded_from_supine_y,unloaded_from_supine_z,tre_mm\n"
            "clip,60.3,25.4,20,60,25,20,0.5\n");
  const std::string html = page(shown_);
  EXPECT_NE(html.find("drawn 20 times as long"), std::string::npos);
  for (const char* plane : {"axial", "sagittal", "coronal"}) {
    const auto views =
        between(html, std::string("aria-label=\"") + plane + " view of the errors", "</svg>");
    ASSERT_EQ(views.size(), 1u);
    EXPECT_NE(views[0].find(">clip</text>"), std::string::npos);
  }
  EXPECT_NE(html.find("x1=\"46.0\" y1=\"52.0\" x2=\"64.0\" y2=\"76.0\""), std::string::npos);
}

// Where one level ends the next begins, although its values are others: 200, 100 and 400, 200 are
// one halved twice.
TEST_F(Report, SimilarityIsOneCurve) {
  const auto curves = between(page({}), "<polyline", ">");
  ASSERT_EQ(curves.size(), 2u);
  const auto points = between(curves[0] + curves[1], "points=\"", " \"");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].substr(points[0].find(' ') + 1), points[1].substr(0, points[1].find(' ')));
}

// Sliders work by keys because they are the browser's own, and have names for those who hear them.
TEST_F(Report, HasASliderForEachPlane) {
  const auto sliders = between(page(shown_), "<input type=\"range\"", ">");
  ASSERT_EQ(sliders.size(), 3u);
  for (const std::string& slider : sliders)
    EXPECT_NE(slider.find("aria-label"), std::string::npos);
}

TEST_F(Report, WithoutImagesAndLandmarksSaysSo) {
  std::filesystem::remove(folder_ / "landmarks.csv");
  const std::string html = page({});
  EXPECT_NE(html.find("no slices to compare"), std::string::npos);
  EXPECT_EQ(html.find("<input"), std::string::npos);
  EXPECT_EQ(html.find("histogram"), std::string::npos);
}

TEST_F(Report, OfSomethingElseIsRefused) {
  text_file(folder_ / "summary.json", "{\"command\": \"mesh\"}");
  expect_error([&] { page({}); }, {"no finished registration", "--output"});
  text_file(folder_ / "summary.json", summary);
  std::filesystem::remove(folder_ / "used.prm");
  expect_error([&] { page({}); }, {"no used.prm"});
}

} // namespace
} // namespace prosup::tests
