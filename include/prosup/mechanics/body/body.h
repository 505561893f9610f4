#ifndef PROSUP_MECHANICS_BODY_H
#define PROSUP_MECHANICS_BODY_H

#include <deal.II/base/partitioner.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <memory>
#include <vector>

#include "prosup/mechanics/body/element.h"

namespace prosup::mechanics {

/// Three components per node, interleaved (x0 y0 z0 x1 ...), owned nodes first
/// and then the ghosts; units depend on the quantity (mm, mm/s, g mm/s^2).
using NodeVector = dealii::LinearAlgebra::distributed::Vector<double>;

/// A boundary face of an element.
struct BoundaryFace {
  std::vector<unsigned> nodes; ///< three corners, then the nodes of the edges if quadratic
  dealii::types::boundary_id id;
};

/// A body of tetrahedra: the nodes and elements of one rank's part of a (serial or distributed)
/// simplex triangulation, numbered for locality, and the exchange between the ranks. It knows
/// no image.
class Body {
public:
  /// @throws Error if a cell is not a tetrahedron.
  explicit Body(const dealii::Triangulation<3>& triangulation, Element element = {});

  MPI_Comm communicator() const { return communicator_; }
  const Element& element() const { return element_; }

  unsigned n_owned_nodes() const { return n_owned_nodes_; }
  /// Owned nodes and ghosts.
  unsigned n_local_nodes() const { return n_local_nodes_; }
  /// Number of cells() of all ranks.
  unsigned n_global_cells() const { return n_global_elements_ * element_.n_cells(); }

  /// Owned elements of this rank. Those with nodes of other ranks come first; within both groups
  /// elements are ordered for locality.
  unsigned n_elements() const { return static_cast<unsigned>(material_ids_.size()); }
  /// Local numbers of the element().n_nodes() nodes of an element: its corners,
  /// and for quadratic elements the nodes of `tet_edges`.
  const unsigned* element_nodes(unsigned element) const {
    return element_nodes_.data() + static_cast<std::size_t>(element_.n_nodes()) * element;
  }
  /// Material id (tissue label) of each owned element.
  const std::vector<unsigned>& material_ids() const { return material_ids_; }

  /// The linear tetrahedra that interpolate nodal fields between the nodes, as
  /// local node numbers: the elements themselves, or the `tet_children` of each
  /// quadratic one.
  const std::vector<std::array<unsigned, 4>>& cells() const { return cells_; }
  /// Index of each of these cells in the mesh from which the triangulation was made; child c of
  /// the mesh cell i has the index 8 i + c.
  const std::vector<unsigned>& cell_ids() const { return cell_ids_; }

  /// Positions of the nodes in the triangulation, ghosts included, mm. The additional nodes of
  /// quadratic elements lie in the middle of straight edges.
  const NodeVector& vertex_positions() const { return vertex_positions_; }

  /// Gives `vector` the layout of this body and sets it to zero.
  void initialize(NodeVector& vector) const;

  /// The boundary faces of the elements of this rank; see boundary.h.
  const std::vector<BoundaryFace>& boundary_faces() const { return boundary_faces_; }

  /// Values of `vector` at the corners of all cells, indexed by cell id, on
  /// rank 0 of the communicator; empty elsewhere.
  std::vector<std::array<dealii::Point<3>, 4>> gather_at_cells(const NodeVector& vector) const;

private:
  void number_nodes(const dealii::Triangulation<3>& triangulation);
  void sort_elements();
  void list_cells();

  MPI_Comm communicator_;
  const Element element_;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
  unsigned n_owned_nodes_ = 0;
  unsigned n_local_nodes_ = 0;
  unsigned n_global_elements_ = 0;
  std::vector<unsigned> element_nodes_;
  std::vector<unsigned> material_ids_;
  std::vector<unsigned> mesh_cells_; // of each element
  std::vector<std::array<unsigned, 4>> cells_;
  std::vector<unsigned> cell_ids_;
  std::vector<BoundaryFace> boundary_faces_;
  NodeVector vertex_positions_;
};

/// Number of nodes of all ranks.
inline unsigned n_global_nodes(const Body& body) {
  return static_cast<unsigned>(body.vertex_positions().size() / 3);
}

/// Sums values at all local nodes over the ranks that share a node; the result is valid at ghosts
/// too. Collective.
std::vector<double> sum_over_ranks(const Body& body, const std::vector<double>& at_local_nodes);

/// The three values of one node.
inline dealii::Tensor<1, 3> node_value(const NodeVector& vector, unsigned local_node) {
  const double* v = vector.begin() + 3 * static_cast<std::size_t>(local_node);
  return dealii::Tensor<1, 3>({v[0], v[1], v[2]});
}

} // namespace prosup::mechanics

#endif
