#ifndef PROSUP_FDM_BREAST_MESH_H
#define PROSUP_FDM_BREAST_MESH_H

#include <array>
#include <cstdint>
#include <vector>

#include "prosup/fdm/vector_field.h"

namespace prosup::fdm {

/// Tetrahedra of the breast as the grid moves it: cell i has the same nodes in
/// both configurations.
struct BreastMesh {
  std::vector<Point<3>> unloaded;             ///< X, LPS mm
  std::vector<Point<3>> loaded;               ///< x = X + u(X), LPS mm
  std::vector<std::array<unsigned, 4>> cells; ///< positively oriented in X
  std::vector<std::uint8_t> tissue;           ///< label of each cell
};

/// Cuts the grid cells of `displacement` that hold tissue into six tetrahedra
/// each (Kuhn's, which fit each other); on them u is linear and equal to that of
/// the grid at its points. A cell holds tissue if a voxel of `tissue_labels` is at
/// one of 27 evenly spread points of it, moved to the loaded image; its label is
/// that of most of them.
/// @throws Error if there is none.
BreastMesh breast_mesh(const VectorField& displacement, const image::LabelImage& labels,
                       const std::vector<unsigned>& tissue_labels);

/// The point X of the grid with X + u(X) = x, by Newton's method on the trilinear
/// u from X = x - u(x). Where it does not converge (u folds) the nearest found.
Point<3> unloaded_position(const VectorField& displacement, const Point<3>& x);

} // namespace prosup::fdm

#endif
