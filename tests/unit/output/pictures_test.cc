#include "prosup/output/pictures.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <array>
#include <cmath>

#include "expect_error.h"
#include "temporary_folder.h"

namespace prosup::tests {
namespace {

using namespace prosup::output;

using image::LabelImage;
using image::ScalarImage;
using image::VoxelGrid;

/// A PNG file; pixel (0, 0) at the top left.
class Picture {
public:
  explicit Picture(const std::filesystem::path& file) {
    reader_->SetFileName(file.c_str());
    reader_->Update();
    reader_->GetOutput()->GetDimensions(size_.data());
  }
  int width() const { return size_[0]; }
  int height() const { return size_[1]; }
  std::array<int, 3> operator()(int x, int y) const {
    std::array<int, 3> colour;
    for (int c = 0; c < 3; ++c)
      colour[std::size_t(c)] =
          int(reader_->GetOutput()->GetScalarComponentAsDouble(x, size_[1] - 1 - y, 0, c));
    return colour;
  }
  /// Colour at a place of a panel given in parts of its width and height, where
  /// the panels are in `columns` and `rows`; titles take little of the height.
  std::array<int, 3> at(double column, double columns, double row, double rows) const {
    return (*this)(int(column / columns * width()), int(row / rows * height()));
  }

private:
  vtkNew<vtkPNGReader> reader_;
  std::array<int, 3> size_{};
};

/// RAS axes, as NIfTI files have them, 1 mm; the field of view is the box from
/// (-30, -30, -30) to (30, 30, 30) in LPS.
VoxelGrid ras_grid() {
  VoxelGrid grid;
  grid.size = {60, 60, 60};
  grid.origin = dealii::Point<3>(29.5, 29.5, -29.5);
  grid.direction = dealii::Tensor<2, 3>({{-1., 0., 0.}, {0., -1., 0.}, {0., 0., 1.}});
  return grid;
}

template <class Function>
void fill(ScalarImage& image, Function&& value) {
  for (std::size_t k = 0; k < 60; ++k)
    for (std::size_t j = 0; j < 60; ++j)
      for (std::size_t i = 0; i < 60; ++i)
        image(i, j, k) = float(value(image.grid.physical(double(i), double(j), double(k))));
}

class Pictures : public ::testing::Test {
protected:
  Pictures() : mask(ras_grid(), 1), image(ras_grid()), other(ras_grid(), 50.f) {}
  LabelImage mask;
  ScalarImage image, other;
  TemporaryFolder folder;
};

// A light that grows to the left, to posterior or to superior is brighter at
// that side of the picture where a radiologist looks for it.
TEST_F(Pictures, SidesAreTheRadiologists) {
  const struct {
    unsigned axis;             // along which the intensity grows, LPS
    const char* file;          // in which it shows
    double bright[2], dark[2]; // places in the first of two panels
  } cases[] = {{0, "slices_axial.png", {0.8, 0.3}, {0.2, 0.3}},
               {1, "slices_axial.png", {0.3, 0.85}, {0.3, 0.25}},
               {1, "slices_sagittal.png", {0.8, 0.3}, {0.2, 0.3}},
               {2, "slices_sagittal.png", {0.3, 0.25}, {0.3, 0.85}},
               {0, "slices_coronal.png", {0.8, 0.3}, {0.2, 0.3}},
               {2, "slices_coronal.png", {0.3, 0.25}, {0.3, 0.85}}};
  for (const auto& c : cases) {
    fill(image, [&](const Point<3>& p) { return 100. + p[c.axis]; });
    write_unloading_slices(image, mask, image, folder / "");
    const Picture picture(folder / c.file);
    EXPECT_GT(picture.at(c.bright[0], 2., c.bright[1], 1.)[0], 170) << c.file << c.axis;
    EXPECT_LT(picture.at(c.dark[0], 2., c.dark[1], 1.)[0], 90) << c.file << c.axis;
  }
}

TEST_F(Pictures, SizeGivesSquarePixels) {
  fill(image, [](const Point<3>& p) { return p[0]; });
  write_slices({{{"one", {&image, {-30., 30.}}, {}}}}, {{-30., -15., -10.}, {30., 15., 10.}, {}},
               folder / "");
  const Picture axial(folder / "slices_axial.png"), sagittal(folder / "slices_sagittal.png");
  EXPECT_EQ(axial.width(), 1500);
  EXPECT_NEAR(axial.height(), 1484 * 30 / 60 + 42, 1);
  EXPECT_NEAR(sagittal.height(), 1484 * 20 / 30 + 42, 1);
}

// Where the first image is brighter red, darker blue, equal white.
TEST_F(Pictures, DifferencesAreBlueWhiteRed) {
  fill(image, [](const Point<3>& p) { return 50. + (p[0] > 10. ? 30. : p[0] < -10. ? -30. : 0.); });
  const ShownImage first{&image, {0., 100.}}, second{&other, {0., 100.}};
  write_slices({{{"difference", first, second}}}, {{-30., -30., -30.}, {30., 30., 30.}, {}},
               folder / "");
  const Picture picture(folder / "slices_axial.png");
  const auto blue = picture.at(0.1, 1., 0.3, 1.), white = picture.at(0.4, 1., 0.3, 1.),
             red = picture.at(0.9, 1., 0.3, 1.);
  EXPECT_GT(blue[2], blue[0] + 100);
  EXPECT_GT(red[0], red[2] + 100);
  EXPECT_EQ(white, (std::array<int, 3>{255, 255, 255}));
}

TEST_F(Pictures, RegistrationHasSixPanelsInEachPicture) {
  fill(image, [](const Point<3>& p) { return 50. + 20. * std::sin((p[0] + p[1] + p[2]) / 3.); });
  fill(other, [](const Point<3>& p) { return 50. + 20. * std::sin((p[0] - p[1] - p[2]) / 3.); });
  write_registration_slices({image, other, mask, mask, image, image}, folder / "");
  for (const char* name : {"slices_axial.png", "slices_sagittal.png", "slices_coronal.png"}) {
    const Picture picture(folder / name);
    EXPECT_EQ(picture.width(), 1500);
    bool grey_panel_varies = false, before_differs = false;
    for (double x = 0.1; x < 0.95; x += 0.02) {
      grey_panel_varies =
          grey_panel_varies || picture.at(x, 3., 0.4, 2.) != picture.at(0.1, 3., 0.4, 2.);
      before_differs = before_differs || picture.at(2. + x, 3., 0.4, 2.)[1] < 200;
      EXPECT_EQ(picture.at(2. + x, 3., 1.4, 2.)[1], 255) << name; // equal after
    }
    EXPECT_TRUE(grey_panel_varies) << name;
    EXPECT_TRUE(before_differs) << name;
  }
}

TEST_F(Pictures, TitlesAreWritten) {
  fill(image, [](const Point<3>& p) { return p[0]; });
  write_slices({{{"MMMM", {&image, {-30., 30.}}, {}}}}, {{-30., -30., -30.}, {30., 30., 30.}, {}},
               folder / "");
  const Picture picture(folder / "slices_axial.png");
  int n_bright = 0;
  for (int x = 600; x < 900; ++x)
    for (int y = 0; y < 34; ++y)
      n_bright += picture(x, y)[0] > 200;
  EXPECT_GT(n_bright, 100);
}

TEST_F(Pictures, EmptyMaskAndMissingFolderAreErrors) {
  fill(image, [](const Point<3>& p) { return p[0]; });
  expect_error([&] { write_unloading_slices(image, mask, image, folder / "missing"); },
               {"slices_axial.png", "cannot be written"});
  const LabelImage empty(ras_grid(), 0);
  expect_error([&] { slice_box({&mask, &empty}); }, {"mask is empty"});
}

} // namespace
} // namespace prosup::tests
