#ifndef PROSUP_MECHANICS_MEMBRANE_H
#define PROSUP_MECHANICS_MEMBRANE_H

#include <array>
#include <vector>

#include "membrane_triangle.h"
#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

/// The linear triangles of the faces of this rank on which a skin lies, as local nodes; the four
/// parts of a quadratic face. Empty if the skin has no stiffness.
std::vector<std::array<unsigned, 3>> membrane_triangles(const Body& body, const Skin& skin);

/// The positions of a triangle's corners.
MembraneTriangle::Corners corners_of(const std::array<unsigned, 3>& triangle,
                                     const NodeVector& positions);

/// The skin of a body under explicit dynamics: MembraneTriangle's forces for all triangles of this
/// rank, without its tangents.
class Membrane {
public:
  Membrane(const Body& body, const Skin& skin);

  /// Makes `unloaded` (positions with ghosts) the stress-free state. Local.
  void set_reference(const NodeVector& unloaded);
  /// Adds dE/dx for the positions x, in the layout of the element kernels, to `force` at all
  /// local nodes. Local.
  void add_forces(const double* positions, double* force) const;
  /// Adds the norms of the blocks in a row of the triangles' tangents, summed, at local nodes,
  /// g/s^2. Local.
  void add_stiffness_bound(const NodeVector& unloaded, const NodeVector& displacement,
                           std::vector<double>& bound) const;

private:
  struct Reference {
    PlaneMatrix inverse_metric; ///< M^-1
    double determinant;         ///< det M
    double area_stiffness;      ///< A s
  };

  const double stiffness_;
  const std::vector<std::array<unsigned, 3>> triangles_;
  std::vector<Reference> references_;
};

} // namespace prosup::mechanics

#endif
