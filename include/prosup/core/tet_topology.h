#ifndef PROSUP_CORE_TET_TOPOLOGY_H
#define PROSUP_CORE_TET_TOPOLOGY_H

#include <array>

namespace prosup {

/// Corners of the edges of a tetrahedron, in deal.II's order. In a quadratic tetrahedron, nodes 0
/// to 3 are the corners and node 4 + e is the midpoint of edge e.
constexpr std::array<std::array<unsigned, 2>, 6> tet_edges{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// Nodes of the eight linear tetrahedra into which a quadratic one is divided: four at the corners,
/// and four around the diagonal 4-9 of the octahedron that remains. They are positively oriented if
/// the quadratic tetrahedron is.
constexpr std::array<std::array<unsigned, 4>, 8> tet_children{{{0, 4, 6, 7},
                                                               {4, 1, 5, 8},
                                                               {6, 5, 2, 9},
                                                               {7, 8, 9, 3},
                                                               {4, 5, 6, 9},
                                                               {4, 6, 7, 9},
                                                               {4, 7, 8, 9},
                                                               {4, 8, 5, 9}}};

} // namespace prosup

#endif
