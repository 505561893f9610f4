#include "contour.h"

#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "prosup/image/filters.h"

namespace prosup::mesh {

namespace {

using image::LabelImage;
using image::ScalarImage;
using image::VoxelGrid;

/// Samples with a layer around them that lies outside; `phi` avoids zero, so
/// that no two vertices of the contour coincide but those the layer makes.
ScalarImage padded_samples(const LevelSet& level_set, double spacing_mm) {
  const auto& [low, high] = level_set.box();
  VoxelGrid grid;
  for (unsigned d = 0; d < 3; ++d) {
    const double n_cells = std::max(1., std::ceil((high[d] - low[d]) / spacing_mm));
    grid.spacing[d] = (high[d] - low[d]) / n_cells;
    grid.size[d] = std::size_t(n_cells) + 3;
    grid.origin[d] = low[d] - grid.spacing[d];
  }
  const float smallest = float(0.02 * spacing_mm);
  ScalarImage samples(grid, float(spacing_mm));
  for (std::size_t k = 1; k + 1 < grid.size[2]; ++k)
    for (std::size_t j = 1; j + 1 < grid.size[1]; ++j)
      for (std::size_t i = 1; i + 1 < grid.size[0]; ++i) {
        const float phi = float(level_set.value(grid.physical(double(i), double(j), double(k))));
        samples(i, j, k) = std::copysign(std::max(std::abs(phi), smallest), phi);
      }
  return samples;
}

/// Keeps the largest connected set of samples inside, and none of its cavities.
/// Returns the number of its samples over that of the samples inside before, or
/// zero if there is none.
double keep_one_body(ScalarImage& samples) {
  LabelImage inside(samples.grid);
  std::transform(samples.values.begin(), samples.values.end(), inside.values.begin(),
                 [](float phi) { return phi < 0.f ? 1 : 0; });
  const LabelImage body = image::fill_holes(image::largest_component(inside));
  double n_inside = 0., n_body = 0.;
  for (std::size_t v = 0; v < body.values.size(); ++v) {
    samples.values[v] = std::copysign(samples.values[v], body.values[v] ? -1.f : 1.f);
    n_inside += inside.values[v];
    n_body += body.values[v];
  }
  return n_inside > 0. ? n_body / n_inside : 0.;
}

vtkNew<vtkPolyData> marching_cubes(const ScalarImage& samples) {
  const VoxelGrid& grid = samples.grid;
  vtkNew<vtkImageData> image;
  image->SetDimensions(int(grid.size[0]), int(grid.size[1]), int(grid.size[2]));
  image->SetSpacing(grid.spacing[0], grid.spacing[1], grid.spacing[2]);
  image->SetOrigin(grid.origin[0], grid.origin[1], grid.origin[2]);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::copy(samples.values.begin(), samples.values.end(),
            static_cast<float*>(image->GetScalarPointer()));
  vtkNew<vtkFlyingEdges3D> filter;
  filter->SetInputData(image);
  filter->SetValue(0, 0.);
  filter->ComputeNormalsOff();
  filter->ComputeScalarsOff();
  filter->Update();
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(filter->GetOutput());
  return surface;
}

/// Vertices between a sample on a face of the box and the layer outside move to
/// that sample: the cap then is exactly plane and its rim where phi is zero.
Point<3> clamped_to_box(const double (&x)[3], const std::array<Point<3>, 2>& box,
                        double tolerance) {
  Point<3> result(x[0], x[1], x[2]);
  for (unsigned d = 0; d < 3; ++d) {
    if (x[d] < box[0][d] + tolerance)
      result[d] = box[0][d];
    else if (x[d] > box[1][d] - tolerance)
      result[d] = box[1][d];
  }
  return result;
}

std::uint8_t patch_of(const TriangleMesh& surface, const std::array<unsigned, 3>& triangle,
                      const std::array<Point<3>, 2>& box) {
  for (unsigned d = 0; d < 3; ++d)
    for (unsigned s = 0; s < 2; ++s)
      if (std::all_of(triangle.begin(), triangle.end(),
                      [&](unsigned node) { return surface.points[node][d] == box[s][d]; }))
        return std::uint8_t(2 * d + s);
  return TriangleMesh::free_surface;
}

/// Merges coinciding vertices and drops the triangles that this makes degenerate.
TriangleMesh welded(vtkPolyData& polygons, const std::array<Point<3>, 2>& box, double tolerance) {
  TriangleMesh surface;
  std::map<std::array<double, 3>, unsigned> number;
  std::vector<unsigned> node(polygons.GetNumberOfPoints());
  for (vtkIdType p = 0; p < polygons.GetNumberOfPoints(); ++p) {
    double x[3];
    polygons.GetPoint(p, x);
    const Point<3> q = clamped_to_box(x, box, tolerance);
    const auto [entry, is_new] =
        number.try_emplace({q[0], q[1], q[2]}, unsigned(surface.points.size()));
    if (is_new)
      surface.points.push_back(q);
    node[p] = entry->second;
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < polygons.GetNumberOfCells(); ++c) {
    polygons.GetCellPoints(c, ids);
    const std::array<unsigned, 3> t{node[ids->GetId(0)], node[ids->GetId(1)], node[ids->GetId(2)]};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      continue;
    surface.triangles.push_back(t);
    surface.patch.push_back(patch_of(surface, t, box));
  }
  return surface;
}

} // namespace

Contour contour(const LevelSet& phi, double spacing_mm) {
  Contour result;
  ScalarImage samples = padded_samples(phi, spacing_mm);
  result.body_fraction = keep_one_body(samples);
  if (result.body_fraction == 0.)
    return result;
  const auto polygons = marching_cubes(samples);
  result.surface = welded(*polygons, phi.box(), 1e-3 * spacing_mm);
  if (enclosed_volume(result.surface) < 0.)
    for (auto& triangle : result.surface.triangles)
      std::swap(triangle[1], triangle[2]);
  return result;
}

} // namespace prosup::mesh
