#ifndef PROSUP_MECHANICS_BODY_H
#define PROSUP_MECHANICS_BODY_H

#include <deal.II/base/partitioner.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <memory>
#include <set>
#include <vector>

namespace prosup::mechanics {

/// Three components per node, interleaved (x0 y0 z0 x1 ...), owned nodes first
/// and then the ghosts; units depend on the quantity (mm, mm/s, g mm/s^2).
using NodeVector = dealii::LinearAlgebra::distributed::Vector<double>;

/// A body discretised by linear tetrahedra: the nodes and cells of one rank's
/// part of a (serial or distributed) simplex triangulation, numbered for
/// locality, and the exchange between the ranks. It knows no image.
class Body {
public:
  /// @throws Error if a cell is not a tetrahedron.
  explicit Body(const dealii::Triangulation<3>& triangulation);

  MPI_Comm communicator() const { return communicator_; }

  unsigned n_owned_nodes() const { return n_owned_nodes_; }
  /// Owned nodes and ghosts.
  unsigned n_local_nodes() const { return n_local_nodes_; }
  unsigned n_global_nodes() const { return n_global_nodes_; }
  unsigned n_global_cells() const { return n_global_cells_; }

  /// Corners of each owned cell as local node numbers, ordered for locality.
  const std::vector<std::array<unsigned, 4>>& cells() const { return cells_; }
  /// Material id (tissue label) of each owned cell.
  const std::vector<unsigned>& material_ids() const { return material_ids_; }
  /// Index of each owned cell in the mesh that the triangulation was made of.
  const std::vector<unsigned>& cell_ids() const { return cell_ids_; }

  /// Positions of the triangulation's vertices, ghosts included, mm.
  const NodeVector& vertex_positions() const { return vertex_positions_; }

  /// Gives `vector` this body's layout, all zero.
  void initialize(NodeVector& vector) const;

  /// For each local node: does it lie on a boundary face with one of `ids`?
  std::vector<bool> nodes_on_boundary(const std::set<dealii::types::boundary_id>& ids) const;

  /// Values of `vector` at the corners of all cells, indexed by cell id, on
  /// rank 0 of the communicator; empty elsewhere.
  std::vector<std::array<dealii::Point<3>, 4>> gather_at_cells(const NodeVector& vector) const;

private:
  struct BoundaryNode {
    unsigned node;
    dealii::types::boundary_id id;
  };

  void number_nodes(const dealii::Triangulation<3>& triangulation);
  void sort_cells();

  MPI_Comm communicator_;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
  unsigned n_owned_nodes_ = 0;
  unsigned n_local_nodes_ = 0;
  unsigned n_global_nodes_ = 0;
  unsigned n_global_cells_ = 0;
  std::vector<std::array<unsigned, 4>> cells_;
  std::vector<unsigned> material_ids_;
  std::vector<unsigned> cell_ids_;
  std::vector<BoundaryNode> boundary_nodes_;
  NodeVector vertex_positions_;
};

/// View of the three values of one node.
inline dealii::Tensor<1, 3> node_value(const NodeVector& vector, unsigned local_node) {
  const double* v = vector.begin() + 3 * static_cast<std::size_t>(local_node);
  return dealii::Tensor<1, 3>({v[0], v[1], v[2]});
}

} // namespace prosup::mechanics

#endif
