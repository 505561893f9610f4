#include "node_relocation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "prosup/mesh/quality.h"

namespace prosup::mesh {

namespace {

using Vector = dealii::Tensor<1, 3>;

/// The cells around each node.
std::vector<std::vector<unsigned>> node_stars(const TetMesh& mesh) {
  std::vector<std::vector<unsigned>> stars(mesh.points.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const unsigned node : mesh.cells[c])
      stars[node].push_back(unsigned(c));
  return stars;
}

/// What is wanted of every cell.
struct Goal {
  double height; // mm
  static constexpr double quality = 0.4;

  /// The lesser of height and radius ratio over what is wanted, negative if inverted.
  double reached(const TetMesh& mesh, std::size_t c) const {
    const auto x = cell_corners(mesh, c);
    const double ratio = radius_ratio(x);
    return std::min(std::copysign(min_height(x), ratio) / height, ratio / quality);
  }

  /// The least of `cells`, or of the first of them if these do not exceed `limit` already.
  double reached(const TetMesh& mesh, const std::vector<unsigned>& cells, double limit) const {
    double result = std::numeric_limits<double>::infinity();
    for (const unsigned c : cells)
      if ((result = std::min(result, reached(mesh, c))) <= limit)
        break;
    return result;
  }
};

/// The directions to the corners and face centres of a cube.
std::vector<Vector> search_directions() {
  std::vector<Vector> directions;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k)
        if (const int n = i * i + j * j + k * k; n == 1 || n == 3)
          directions.push_back(Vector({double(i), double(j), double(k)}) / std::sqrt(double(n)));
  return directions;
}

/// Pattern search: tries steps in all directions, the best wins, and the step is
/// halved where none helps.
void relocate(TetMesh& mesh, unsigned node, const std::vector<unsigned>& star, unsigned patches,
              const SurfaceProjection& projection, const Goal& goal) {
  static const std::vector<Vector> directions = search_directions();
  const double first_step = 0.5 * goal.height;
  double best = goal.reached(mesh, star, -std::numeric_limits<double>::infinity());
  for (double step = first_step; step > 0.1 * first_step;) {
    const Point<3> start = mesh.points[node];
    Point<3> winner = start;
    for (const Vector& direction : directions) {
      mesh.points[node] = start + step * direction;
      if (!projection.apply(mesh.points[node], patches))
        continue;
      // Smaller gains would only shuffle nodes about.
      const double least = best + 1e-3;
      if (const double reached = goal.reached(mesh, star, least); reached > least) {
        best = reached;
        winner = mesh.points[node];
      }
    }
    mesh.points[node] = winner;
    if (winner == start)
      step *= 0.5;
  }
}

} // namespace

void improve_worst_cells(TetMesh& mesh, const std::vector<unsigned>& patches,
                         const SurfaceProjection& projection, double wanted_height) {
  constexpr unsigned n_sweeps = 4;
  const Goal goal{wanted_height};
  const auto stars = node_stars(mesh);
  for (unsigned sweep = 0; sweep < n_sweeps; ++sweep) {
    std::vector<std::pair<double, unsigned>> worst;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      if (const double reached = goal.reached(mesh, c); reached < 1.)
        worst.push_back({reached, unsigned(c)});
    std::sort(worst.begin(), worst.end());
    for (const auto& [reached, c] : worst)
      for (const unsigned node : mesh.cells[c])
        relocate(mesh, node, stars[node], node < patches.size() ? patches[node] : 0u, projection,
                 goal);
  }
}

} // namespace prosup::mesh
