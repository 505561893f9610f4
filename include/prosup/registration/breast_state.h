#ifndef PROSUP_REGISTRATION_BREAST_STATE_H
#define PROSUP_REGISTRATION_BREAST_STATE_H

#include <map>
#include <string>
#include <vector>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::registration {

/// What the simulation of a breast goes on from, on any number of ranks. Nodes have the numbers of
/// the mesh, followed by those of mesh::refined() where elements are quadratic.
struct BreastState {
  /// That the mesher made; on the first rank of the breast.
  mesh::TetMesh mesh;
  /// The nodes of which this rank tells. All ranks together tell of all of them.
  std::vector<unsigned> nodes;
  /// Three numbers at each of these nodes, by name.
  std::map<std::string, std::vector<double>> fields;
  std::map<std::string, double> numbers;
};

} // namespace prosup::registration

#endif
