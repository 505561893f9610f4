#ifndef PROSUP_BENCHMARKS_HARD_CASES_MESH_EDITS_H
#define PROSUP_BENCHMARKS_HARD_CASES_MESH_EDITS_H

#include "prosup/mesh/tet_mesh.h"

namespace prosup::benchmarks {

/// Moves inner nodes towards the opposite face of one of their cells until its
/// longest edge over its smallest height is `aspect`, as long as the other cells
/// keep a positive volume. @returns how many cells were made so.
unsigned make_slivers(mesh::TetMesh& mesh, double aspect, unsigned n_wanted);

/// Grows a layer of cells with the tissue `label`, `thickness` mm, on the skin.
void grow_skin(mesh::TetMesh& mesh, double thickness, unsigned label);

} // namespace prosup::benchmarks

#endif
