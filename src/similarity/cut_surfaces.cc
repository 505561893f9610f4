#include "cut_surfaces.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "prosup/core/collective.h"
#include "prosup/mechanics/body/boundary.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::similarity {

using namespace dealii;
using mechanics::Body;
using mechanics::node_value;
using mechanics::NodeVector;

namespace {

constexpr auto cut_plane = mesh::boundary_id_of(mesh::BoundaryPart::cut_plane);

constexpr double cell_edge = 8.; // mm, little more than that of usual meshes

/// Unloaded corners, of all ranks, of the faces cut off at the side with the normal `up`.
std::vector<Point<3>> corners_at(const Body& body, const NodeVector& unloaded,
                                 const Tensor<1, 3>& up) {
  const double aligned = std::sqrt(0.5);
  double ends[2] = {-std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    const double height = node_value(body.vertex_positions(), node) * up;
    ends[0] = std::max(ends[0], -height);
    ends[1] = std::max(ends[1], height);
  }
  Utilities::MPI::max(ArrayView<const double>(ends, 2), body.communicator(),
                      ArrayView<double>(ends, 2));
  const double middle = 0.5 * (ends[1] - ends[0]); // the normals of faces may point inwards
  const auto faces = faces_on_boundary(
      body, {cut_plane}, [&](const Tensor<1, 3>& centre, const Tensor<1, 3>& normal) {
        return std::abs(normal * up) > aligned && centre * up > middle;
      });
  std::vector<Point<3>> corners;
  for (const std::size_t face : faces)
    for (unsigned v = 0; v < 3; ++v)
      corners.emplace_back(node_value(unloaded, body.boundary_faces()[face].nodes[v]));
  return all_gathered(corners, body.communicator());
}

} // namespace

CutSurfaces::Surface::Surface(const std::vector<Point<3>>& points, const Tensor<1, 3>& up_,
                              const Tensor<1, 3>& first, const Tensor<1, 3>& second)
    : up(up_), along{first, second} {
  for (unsigned axis = 0; axis < 2; ++axis) {
    double high = -std::numeric_limits<double>::max();
    low[axis] = std::numeric_limits<double>::max();
    for (const Point<3>& point : points) {
      low[axis] = std::min(low[axis], point * along[axis]);
      high = std::max(high, point * along[axis]);
    }
    size[axis] = 1 + static_cast<std::size_t>((high - low[axis]) / cell_edge);
  }
  heights.assign(size[0] * size[1], 0.);
  std::vector<double> n(heights.size(), 0.);
  for (const Point<3>& point : points) {
    height(point) += point * up;
    n[cell(point, 0) + size[0] * cell(point, 1)] += 1.;
  }
  std::vector<bool> known(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    known[i] = n[i] > 0.;
    heights[i] /= std::max(n[i], 1.);
  }
  fill_gaps(std::move(known));
  const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
  lowest = *least;
  highest = *most;
}

std::size_t CutSurfaces::Surface::cell(const Point<3>& X, unsigned axis) const {
  const double i = std::floor((X * along[axis] - low[axis]) / cell_edge);
  return static_cast<std::size_t>(std::clamp(i, 0., static_cast<double>(size[axis] - 1)));
}

double& CutSurfaces::Surface::height(const Point<3>& X) {
  return heights[cell(X, 0) + size[0] * cell(X, 1)];
}

double CutSurfaces::Surface::height(const Point<3>& X) const {
  return heights[cell(X, 0) + size[0] * cell(X, 1)];
}

/// Cells without a height get the mean of their known neighbours, layer by layer.
void CutSurfaces::Surface::fill_gaps(std::vector<bool> known) {
  const long n[2] = {static_cast<long>(size[0]), static_cast<long>(size[1])};
  while (std::find(known.begin(), known.end(), false) != known.end()) {
    const std::vector<bool> before = known;
    for (long j = 0; j < n[1]; ++j)
      for (long i = 0; i < n[0]; ++i) {
        double sum = 0., n_known = 0.;
        const long neighbours[4][2] = {{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}};
        for (const auto& [a, b] : neighbours)
          if (a >= 0 && a < n[0] && b >= 0 && b < n[1] && before[a + n[0] * b]) {
            sum += heights[a + n[0] * b];
            n_known += 1.;
          }
        if (!before[i + n[0] * j] && n_known > 0.) {
          heights[i + n[0] * j] = sum / n_known;
          known[i + n[0] * j] = true;
        }
      }
  }
}

CutSurfaces::CutSurfaces(const Body& body, const NodeVector& unloaded, const Tensor<2, 3>& axes) {
  Tensor<1, 3> axis[3];
  for (unsigned d = 0; d < 3; ++d)
    for (unsigned c = 0; c < 3; ++c)
      axis[d][c] = axes[c][d];
  for (unsigned d = 0; d < 3; ++d)
    for (const double side : {-1., 1.}) {
      const auto corners = corners_at(body, unloaded, side * axis[d]);
      if (!corners.empty())
        surfaces_.emplace_back(corners, side * axis[d], axis[(d + 1) % 3], axis[(d + 2) % 3]);
    }
}

bool CutSurfaces::beyond(const Point<3>& X) const {
  return std::any_of(surfaces_.begin(), surfaces_.end(),
                     [&](const Surface& surface) { return surface.is_passed_by(X); });
}

} // namespace prosup::similarity
