#ifndef PROSUP_MESH_CONTOUR_H
#define PROSUP_MESH_CONTOUR_H

#include "level_set.h"
#include "triangle_mesh.h"

namespace prosup::mesh {

struct Contour {
  TriangleMesh surface;      ///< empty if no sample is inside
  double body_fraction = 0.; ///< samples in the body enclosed, over samples with phi < 0
};

/// The closed surface of the largest part of {x in box: phi(x) < 0} without its
/// cavities, phi being sampled on a grid of about `spacing_mm`: bridges and
/// sheets thinner than that vanish. Where it is cut by the box it lies exactly in
/// the faces of the box.
Contour contour(const LevelSet& phi, double spacing_mm);

} // namespace prosup::mesh

#endif
