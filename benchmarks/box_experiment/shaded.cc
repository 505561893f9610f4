#include "shaded.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "prosup/core/text_file.h"

namespace prosup::benchmarks {

using dealii::Point;
using dealii::Tensor;

namespace {

constexpr int panel_width = 420, height = 480, samples = 2; // per pixel and direction
constexpr double mm_per_panel = 24.5, field = 2.5;          // mm
constexpr unsigned faces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/// Unit vectors to the right and up in the picture, and towards the eye.
struct View {
  Tensor<1, 3> right, up, eye;

  View(double azimuth, double elevation) {
    const double a = azimuth * dealii::numbers::PI / 180.,
                 e = elevation * dealii::numbers::PI / 180.;
    eye = Tensor<1, 3>({std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)});
    right = Tensor<1, 3>({std::cos(a), 0., -std::sin(a)});
    up = cross_product_3d(eye, right);
  }
};

/// Brightness with the depth of what is seen, finer than the picture.
class Raster {
public:
  Raster(int width, int height)
      : width_(width), height_(height),
        depth_(std::size_t(width) * std::size_t(height), -std::numeric_limits<double>::max()),
        colour_(depth_.size(), {255., 255., 255.}) {}

  /// Corners in samples and depth; the colour at the weights of the corners.
  template <typename Colour>
  void triangle(const std::array<Tensor<1, 3>, 3>& p, Colour colour) {
    const auto [low_x, high_x] = std::minmax({p[0][0], p[1][0], p[2][0]});
    const auto [low_y, high_y] = std::minmax({p[0][1], p[1][1], p[2][1]});
    const auto side = [&](unsigned a, unsigned b, double x, double y) {
      return (p[b][0] - p[a][0]) * (y - p[a][1]) - (p[b][1] - p[a][1]) * (x - p[a][0]);
    };
    const double area = side(0, 1, p[2][0], p[2][1]);
    if (area == 0.)
      return;
    for (int y = std::max(0, int(low_y)); y <= std::min(height_ - 1, int(high_y) + 1); ++y)
      for (int x = std::max(0, int(low_x)); x <= std::min(width_ - 1, int(high_x) + 1); ++x) {
        const std::array<double, 3> w{side(1, 2, x, y) / area, side(2, 0, x, y) / area,
                                      side(0, 1, x, y) / area};
        const std::size_t at = std::size_t(y) * std::size_t(width_) + std::size_t(x);
        const double depth = w[0] * p[0][2] + w[1] * p[1][2] + w[2] * p[2][2];
        if (std::min({w[0], w[1], w[2]}) < 0. || depth <= depth_[at])
          continue;
        depth_[at] = depth;
        colour_[at] = colour(w);
      }
  }

  /// @throws Error if the file cannot be written.
  void write(const std::filesystem::path& png) const {
    vtkNew<vtkImageData> image;
    image->SetDimensions(width_ / samples, height_ / samples, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* target = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int y = height_ / samples - 1; y >= 0; --y) // VTK's first row is the lowest
      for (int x = 0; x < width_ / samples; ++x)
        for (unsigned c = 0; c < 3; ++c)
          *target++ = mean(x, y, c);
    vtkNew<vtkPNGWriter> writer;
    writer->SetFileName(png.c_str());
    writer->SetInputData(image);
    writer->Write();
    if (writer->GetErrorCode() != 0)
      throw_cannot_write(png);
  }

private:
  unsigned char mean(int x, int y, unsigned c) const {
    double sum = 0.;
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i)
        sum += colour_[std::size_t(samples * y + j) * std::size_t(width_) +
                       std::size_t(samples * x + i)][c];
    return static_cast<unsigned char>(std::lround(sum / (samples * samples)));
  }

  int width_, height_;
  std::vector<double> depth_;
  std::vector<std::array<double, 3>> colour_;
};

/// Which of two colours a point of the cube has; its faces lie within fields.
bool is_dark(const Point<3>& X) {
  int n = 0;
  for (unsigned d = 0; d < 3; ++d)
    n += static_cast<int>(std::floor(X[d] / field + 0.5));
  return n % 2 != 0;
}

void draw(Raster& raster, const Shape& shape, const View& view, const Point<3>& centre,
          double left) {
  const double scale = samples * panel_width / mm_per_panel;
  const Tensor<1, 3> light = (0.5 * view.up + view.eye - 0.6 * view.right) /
                             (0.5 * view.up + view.eye - 0.6 * view.right).norm();
  for (const auto& cell : *shape.cells)
    for (const auto& face : faces) {
      std::array<Point<3>, 3> x, X;
      std::array<Tensor<1, 3>, 3> seen;
      for (unsigned a = 0; a < 3; ++a) {
        x[a] = shape.position[cell[face[a]]];
        X[a] = shape.material[cell[face[a]]];
        const Tensor<1, 3> from = x[a] - centre;
        seen[a] =
            Tensor<1, 3>({samples * (left + 0.5 * panel_width) + scale * (from * view.right),
                          samples * 0.5 * height - scale * (from * view.up), from * view.eye});
      }
      const Tensor<1, 3> normal = cross_product_3d(x[1] - x[0], x[2] - x[0]);
      const double bright = 0.35 + 0.65 * std::abs(normal * light) / normal.norm();
      raster.triangle(seen, [&](const std::array<double, 3>& w) -> std::array<double, 3> {
        const Point<3> at(w[0] * X[0] + w[1] * X[1] + w[2] * X[2]);
        return is_dark(at) ? std::array<double, 3>{190. * bright, 105. * bright, 95. * bright}
                           : std::array<double, 3>{250. * bright, 225. * bright, 205. * bright};
      });
    }
}

} // namespace

void write_shaded(const std::vector<Shape>& shapes, const std::filesystem::path& png) {
  const View view(32., -18.);
  const Point<3> centre(7.5, 6.4, 7.5);
  Raster raster(samples * panel_width * static_cast<int>(shapes.size()), samples * height);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    draw(raster, shapes[i], view, centre, panel_width * static_cast<double>(i));
  raster.write(png);
}

} // namespace prosup::benchmarks
