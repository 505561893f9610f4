#include "evaluation/surface_locator.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTriangle.h>

#include <cmath>
#include <limits>
#include <random>

namespace prosup::tests {
namespace {

using namespace prosup::evaluation;

/// A wavy sheet of triangles, two of them flat.
struct Sheet {
  Sheet() {
    constexpr unsigned n = 12;
    for (unsigned j = 0; j <= n; ++j)
      for (unsigned i = 0; i <= n; ++i)
        nodes.emplace_back(5. * i, 5. * j, 8. * std::sin(0.7 * i) * std::cos(0.5 * j));
    for (unsigned j = 0; j < n; ++j)
      for (unsigned i = 0; i < n; ++i) {
        const unsigned a = i + (n + 1) * j, b = a + 1, c = a + n + 1, d = c + 1;
        faces.push_back({a, b, d});
        faces.push_back({a, d, c});
      }
    faces.push_back({0, 0, 1});
    faces.push_back({7, 7, 7});
  }

  std::vector<Point<3>> nodes;
  std::vector<SurfaceLocator::Face> faces;
};

std::vector<Point<3>> random_points(unsigned n) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> across(-15., 75.), up(-20., 20.);
  std::vector<Point<3>> points;
  for (unsigned i = 0; i < n; ++i)
    points.emplace_back(across(generator), across(generator), up(generator));
  return points;
}

/// By VTK, from all faces that are not flat.
double squared_distance_by_vtk(const Sheet& sheet, const Point<3>& p) {
  double least = std::numeric_limits<double>::max();
  vtkNew<vtkTriangle> triangle;
  for (std::size_t f = 0; f + 2 < sheet.faces.size(); ++f) {
    for (unsigned a = 0; a < 3; ++a) {
      const Point<3>& x = sheet.nodes[sheet.faces[f][a]];
      triangle->GetPoints()->SetPoint(a, x[0], x[1], x[2]);
    }
    const double at[3] = {p[0], p[1], p[2]};
    double closest[3], parametric[3], squared_distance = 0., weights[3];
    int unused = 0;
    triangle->EvaluatePosition(at, closest, unused, parametric, squared_distance, weights);
    least = std::min(least, squared_distance);
  }
  return least;
}

Point<3> position(const Sheet& sheet, const SurfaceLocator::Hit& hit) {
  Point<3> c;
  for (unsigned a = 0; a < 3; ++a)
    c += hit.weights[a] * Tensor<1, 3>(sheet.nodes[sheet.faces[hit.face][a]]);
  return c;
}

TEST(SurfaceLocator, FindsWhatVtkFindsAmongAllTriangles) {
  const Sheet sheet;
  const SurfaceLocator locator(sheet.nodes, sheet.faces);
  for (const Point<3>& p : random_points(500)) {
    const SurfaceLocator::Hit hit = locator.closest(p);
    const double expected = std::sqrt(squared_distance_by_vtk(sheet, p));
    EXPECT_NEAR(std::sqrt(hit.squared_distance), expected, 1e-9);
    EXPECT_NEAR(position(sheet, hit).distance(p), expected, 1e-9);
    EXPECT_NEAR(hit.weights[0] + hit.weights[1] + hit.weights[2], 1., 1e-12);
  }
}

TEST(SurfaceLocator, AnyGuessGivesTheSamePoint) {
  const Sheet sheet;
  const SurfaceLocator locator(sheet.nodes, sheet.faces);
  std::size_t guess = 0;
  for (const Point<3>& p : random_points(500)) {
    guess = (guess + 37) % sheet.faces.size();
    EXPECT_LT(
        position(sheet, locator.closest(p, guess)).distance(position(sheet, locator.closest(p))),
        1e-9);
  }
}

TEST(SurfaceLocator, GradientsAreThoseOfTheClosestPoint) {
  const Sheet sheet;
  const SurfaceLocator locator(sheet.nodes, sheet.faces);
  constexpr double h = 1e-5;
  unsigned n_compared = 0;
  for (const Point<3>& p : random_points(500)) {
    const SurfaceLocator::Hit hit = locator.closest(p);
    for (unsigned d = 0; d < 3; ++d) {
      Tensor<1, 3> step;
      step[d] = h;
      const SurfaceLocator::Hit before = locator.closest(p - step),
                                after = locator.closest(p + step);
      if (before.face != hit.face || after.face != hit.face)
        continue; // on a crease, where the closest point has no gradient
      bool same_part = true;
      for (unsigned a = 0; a < 3; ++a)
        same_part = same_part && (before.weights[a] > 0.) == (after.weights[a] > 0.);
      if (!same_part)
        continue;
      Tensor<1, 3> expected = (position(sheet, after) - position(sheet, before)) / (2. * h), found;
      for (unsigned a = 0; a < 3; ++a)
        found += hit.gradients[a][d] * Tensor<1, 3>(sheet.nodes[sheet.faces[hit.face][a]]);
      EXPECT_LT((found - expected).norm(), 1e-5);
      ++n_compared;
    }
  }
  EXPECT_GT(n_compared, 1000u);
}

} // namespace
} // namespace prosup::tests
