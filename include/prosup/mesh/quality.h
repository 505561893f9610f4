#ifndef PROSUP_MESH_QUALITY_H
#define PROSUP_MESH_QUALITY_H

#include <array>
#include <cstddef>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// Properties of a mesh that determine accuracy and the explicit time step.
struct MeshQuality {
  std::size_t n_cells = 0;
  std::size_t n_nodes = 0;
  double min_quality = 0.;       ///< smallest radius ratio
  double mean_quality = 0.;      ///< mean radius ratio
  double fraction_below_02 = 0.; ///< fraction of cells with a radius ratio below 0.2
  double volume_mm3 = 0.;
  double min_edge = 0.;   ///< shortest edge, mm
  double mean_edge = 0.;  ///< mean over the six edges of all cells, mm
  double min_height = 0.; ///< smallest height of a cell, mm: determines the time step
  double max_aspect = 0.; ///< largest ratio of longest edge to smallest height; regular: sqrt(3/2)
};

/// Radius ratio 3 r/R of a tetrahedron, with the radii r of the inscribed and R of the
/// circumscribed sphere: 1 if regular, 0 if flat, negative if inverted.
double radius_ratio(const std::array<Point<3>, 4>& corners);

/// Smallest height of a tetrahedron, mm: 3 |V| / largest face area.
double min_height(const std::array<Point<3>, 4>& corners);

/// Corners of cell `c`.
std::array<Point<3>, 4> cell_corners(const TetMesh& mesh, std::size_t c);

/// @throws Error if the mesh has no cells.
MeshQuality measure_quality(const TetMesh& mesh);

} // namespace prosup::mesh

#endif
