#ifndef PROSUP_FDM_BREAST_MESH_H
#define PROSUP_FDM_BREAST_MESH_H

#include <array>
#include <cstdint>
#include <vector>

#include "prosup/fdm/vector_field.h"

namespace prosup::fdm {

/// Tetrahedra of the breast, which move with the grid: the same cells in both
/// configurations.
struct BreastMesh {
  std::vector<Point<3>> unloaded;             ///< X, LPS mm
  std::vector<Point<3>> loaded;               ///< x = X + u(X), LPS mm
  std::vector<std::array<unsigned, 4>> cells; ///< positively oriented in X
  std::vector<std::uint8_t> tissue;           ///< label of each cell
};

/// Cuts each grid cell of `displacement` that holds tissue into six tetrahedra (Kuhn's,
/// which match across faces). On them u is linear, with the values of the grid at the nodes.
/// A cell holds tissue if one of 27 evenly spaced points in it, moved to the loaded image, lies in
/// a voxel with one of the `tissue_labels`; the most frequent one becomes its label.
/// @throws Error if no cell holds tissue.
BreastMesh breast_mesh(const VectorField& displacement, const image::LabelImage& labels,
                       const std::vector<unsigned>& tissue_labels);

/// The point X with X + u(X) = x, by Newton's method on the trilinear u, which starts from
/// X = x - u(x). If it does not converge because u folds, the best point found.
Point<3> unloaded_position(const VectorField& displacement, const Point<3>& x);

} // namespace prosup::fdm

#endif
