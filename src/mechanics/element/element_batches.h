#ifndef PROSUP_MECHANICS_ELEMENT_BATCHES_H
#define PROSUP_MECHANICS_ELEMENT_BATCHES_H

#include <memory>
#include <vector>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

/// The elements of a body in batches for the kernels, in the precision of the body. Nodal fields
/// are laid out as the kernels need them: kernel::node_stride doubles per node, and n_padding_nodes
/// nodes behind those of the body for lanes without an element.
class ElementBatches {
public:
  /// The elements with nodes of other ranks, and two halves of the rest, which are computed while
  /// ghost values are sent in either direction.
  enum Part { interface, first_interior, second_interior };
  static constexpr unsigned n_parts = 3;

  static std::unique_ptr<ElementBatches> create(const Body& body);
  virtual ~ElementBatches() = default;

  virtual void set_material(const Material& material) = 0;
  /// Returns the smallest det dX/dxi at a quadrature point.
  virtual double set_reference(const double* positions) = 0;
  /// Adds internal forces; returns the smallest J.
  virtual double add_forces(Part part, const double* positions, double* force) const = 0;
  /// First pass of averaged nodal pressure: adds volumes to the nodes, one double per node.
  virtual void add_nodal_volumes(Part part, const double* positions, double* volumes) const = 0;
};

/// Nodes of the lanes without an element, behind those of the body.
constexpr unsigned n_padding_nodes = 10;
/// Writes the positions of a unit element to them.
void place_padding_nodes(double* behind_the_nodes);

} // namespace prosup::mechanics

#endif
