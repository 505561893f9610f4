#include "prosup/fdm/breast_mesh.h"

#include <algorithm>

#include "prosup/core/error.h"
#include "prosup/fdm/trilinear_cell.h"
#include "prosup/image/sampling.h"

namespace prosup::fdm {

using namespace dealii;

namespace {

constexpr unsigned none = static_cast<unsigned>(-1);

/// The ways from corner 0 to corner 7 of a cell along its edges; the odd ones give
/// tetrahedra of negative volume unless two corners change places.
constexpr std::array<std::array<unsigned, 4>, 6> kuhn_tets{
    {{0, 1, 3, 7}, {0, 5, 1, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 6, 4, 7}}};

/// The most frequent tissue at points of a cell, 0 if there is none.
std::uint8_t tissue_of_cell(const VectorField& displacement, const std::array<std::size_t, 3>& i,
                            const image::LabelImage& labels,
                            const std::array<bool, 256>& is_tissue) {
  std::array<unsigned, 256> counts{};
  constexpr double at[3] = {1. / 6., 0.5, 5. / 6.};
  for (const double a : at)
    for (const double b : at)
      for (const double c : at) {
        const Point<3> X =
            displacement.grid.physical(double(i[0]) + a, double(i[1]) + b, double(i[2]) + c);
        ++counts[image::nearest_label(labels, X + displacement.value(X))];
      }
  unsigned best = 0;
  for (unsigned label = 0; label < 256; ++label)
    if (is_tissue[label] && counts[label] > 0 && (best == 0 || counts[label] > counts[best]))
      best = label;
  return std::uint8_t(best);
}

} // namespace

BreastMesh breast_mesh(const VectorField& displacement, const image::LabelImage& labels,
                       const std::vector<unsigned>& tissue_labels) {
  const image::VoxelGrid& grid = displacement.grid;
  std::array<bool, 256> is_tissue{};
  for (const unsigned label : tissue_labels)
    is_tissue[label] = true;
  BreastMesh mesh;
  std::vector<unsigned> node_of(grid.n_voxels(), none);
  std::array<std::size_t, 3> i;
  for (i[2] = 0; i[2] + 1 < grid.size[2]; ++i[2])
    for (i[1] = 0; i[1] + 1 < grid.size[1]; ++i[1])
      for (i[0] = 0; i[0] + 1 < grid.size[0]; ++i[0]) {
        const std::uint8_t tissue = tissue_of_cell(displacement, i, labels, is_tissue);
        if (tissue == 0)
          continue;
        std::array<unsigned, 8> corners;
        for (unsigned corner = 0; corner < 8; ++corner) {
          const std::size_t x = i[0] + (corner & 1u), y = i[1] + (corner >> 1 & 1u),
                            z = i[2] + (corner >> 2);
          const std::size_t n = grid.linear_index(x, y, z);
          if (node_of[n] == none) {
            node_of[n] = unsigned(mesh.unloaded.size());
            mesh.unloaded.push_back(grid.physical(double(x), double(y), double(z)));
            mesh.loaded.push_back(mesh.unloaded.back() + displacement.values[n]);
          }
          corners[corner] = node_of[n];
        }
        for (const auto& tet : kuhn_tets) {
          mesh.cells.push_back(
              {corners[tet[0]], corners[tet[1]], corners[tet[2]], corners[tet[3]]});
          mesh.tissue.push_back(tissue);
        }
      }
  if (mesh.cells.empty())
    throw Error("No cell of the simulation grid holds tissue; check the labels.");
  return mesh;
}

Point<3> unloaded_position(const VectorField& displacement, const Point<3>& x) {
  constexpr unsigned max_iterations = 50;
  constexpr double tolerance = 1e-6; // mm
  const double h = displacement.grid.spacing[0];
  Point<3> X = x - displacement.value(x), best = X;
  double smallest = 1e300;
  for (unsigned iteration = 0; iteration < max_iterations; ++iteration) {
    const Tensor<1, 3> gap = X + displacement.value(X) - x;
    if (gap.norm() < smallest) {
      smallest = gap.norm();
      best = X;
    }
    if (smallest < tolerance)
      break;
    Tensor<2, 3> F;
    for (unsigned I = 0; I < 3; ++I) {
      Tensor<1, 3> step;
      step[I] = 0.25 * h;
      const Tensor<1, 3> derivative =
          (displacement.value(X + step) - displacement.value(X - step)) / (0.5 * h);
      for (unsigned k = 0; k < 3; ++k)
        F[k][I] = (k == I ? 1. : 0.) + derivative[k];
    }
    // Where u folds a plain step still goes the right way.
    Tensor<1, 3> step = determinant(F) > 0.05 ? invert(F) * gap : gap;
    if (step.norm() > h)
      step *= h / step.norm();
    // Derivatives over a kink need not lead down.
    X -= (iteration < max_iterations / 2 ? 1. : 0.5) * step;
  }
  return best;
}

} // namespace prosup::fdm
