#ifndef PROSUP_CORE_TET_TOPOLOGY_H
#define PROSUP_CORE_TET_TOPOLOGY_H

#include <array>

namespace prosup {

/// Edges of a tetrahedron by its corners, in deal.II's order. A quadratic
/// tetrahedron has corners 0 to 3 and the node of edge e as node 4 + e.
constexpr std::array<std::array<unsigned, 2>, 6> tet_edges{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// The eight linear tetrahedra between the ten nodes of a quadratic one: four
/// at its corners, and four around the diagonal 4-9 of the octahedron left.
/// They are positively oriented if the whole is.
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
