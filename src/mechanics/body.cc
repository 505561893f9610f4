#include "prosup/mechanics/body.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <algorithm>
#include <numeric>

#include "prosup/core/error.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

IndexSet three_per_node(const IndexSet& nodes) {
  IndexSet components(3 * nodes.size());
  for (auto interval = nodes.begin_intervals(); interval != nodes.end_intervals(); ++interval)
    components.add_range(3 * *interval->begin(), 3 * (interval->last() + 1));
  components.compress();
  return components;
}

template <typename T>
void reorder(std::vector<T>& values, const std::vector<unsigned>& order) {
  std::vector<T> reordered(values.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    reordered[i] = values[order[i]];
  values.swap(reordered);
}

} // namespace

Body::Body(const Triangulation<3>& triangulation)
    : communicator_(triangulation.get_communicator()) {
  if (!triangulation.all_reference_cells_are_simplex())
    throw Error(
        "The mesh of a body has cells that are no tetrahedra; only tetrahedral meshes are "
        "allowed, so convert the others (GridGenerator::convert_hypercube_to_simplex_mesh).");
  n_global_cells_ = triangulation.n_global_active_cells();
  number_nodes(triangulation);
  sort_cells();
}

void Body::number_nodes(const Triangulation<3>& triangulation) {
  const FE_SimplexP<3> element(1);
  DoFHandler<3> nodes(triangulation);
  nodes.distribute_dofs(element);
  DoFRenumbering::Cuthill_McKee(nodes);

  IndexSet active;
  DoFTools::extract_locally_active_dofs(nodes, active);
  const IndexSet owned = three_per_node(nodes.locally_owned_dofs());
  partitioner_ =
      std::make_shared<Utilities::MPI::Partitioner>(owned, three_per_node(active), communicator_);
  n_global_nodes_ = nodes.n_dofs();
  n_owned_nodes_ = nodes.n_locally_owned_dofs();
  n_local_nodes_ = n_owned_nodes_ + partitioner_->n_ghost_indices() / 3;
  initialize(vertex_positions_);

  const auto local = [&](types::global_dof_index node) {
    return partitioner_->global_to_local(3 * node) / 3;
  };
  for (const auto& cell : nodes.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    std::array<unsigned, 4> corners;
    for (unsigned v = 0; v < 4; ++v) {
      corners[v] = local(cell->vertex_dof_index(v, 0));
      for (unsigned c = 0; c < 3; ++c)
        vertex_positions_.local_element(3 * corners[v] + c) = cell->vertex(v)[c];
    }
    cells_.push_back(corners);
    material_ids_.push_back(cell->material_id());
    cell_ids_.push_back(cell->id().get_coarse_cell_id());
    for (const unsigned f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        for (unsigned v = 0; v < 3; ++v)
          boundary_nodes_.push_back(
              {local(cell->face(f)->vertex_dof_index(v, 0)), cell->face(f)->boundary_id()});
  }
  vertex_positions_.update_ghost_values();
}

void Body::sort_cells() {
  std::vector<unsigned> order(cells_.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto first_node = [&](unsigned cell) {
    return *std::min_element(cells_[cell].begin(), cells_[cell].end());
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](unsigned a, unsigned b) { return first_node(a) < first_node(b); });
  reorder(cells_, order);
  reorder(material_ids_, order);
  reorder(cell_ids_, order);
}

void Body::initialize(NodeVector& vector) const {
  vector.reinit(partitioner_);
}

std::vector<bool> Body::nodes_on_boundary(const std::set<types::boundary_id>& ids) const {
  NodeVector marks;
  initialize(marks);
  for (const BoundaryNode& boundary : boundary_nodes_)
    if (ids.count(boundary.id) > 0)
      marks.local_element(3 * boundary.node) = 1.;
  // A node may touch the boundary only through a cell of another rank.
  marks.compress(VectorOperation::add);
  marks.update_ghost_values();
  std::vector<bool> on_boundary(n_local_nodes_);
  for (unsigned node = 0; node < n_local_nodes_; ++node)
    on_boundary[node] = marks.local_element(3 * node) > 0.;
  return on_boundary;
}

std::vector<std::array<Point<3>, 4>> Body::gather_at_cells(const NodeVector& vector) const {
  using CellValues = std::pair<std::vector<unsigned>, std::vector<double>>;
  CellValues mine{cell_ids_, {}};
  mine.second.reserve(12 * cells_.size());
  for (const auto& corners : cells_)
    for (const unsigned node : corners)
      for (unsigned c = 0; c < 3; ++c)
        mine.second.push_back(vector.local_element(3 * node + c));

  std::vector<std::array<Point<3>, 4>> values;
  const std::vector<CellValues> parts = Utilities::MPI::gather(communicator_, mine);
  if (Utilities::MPI::this_mpi_process(communicator_) != 0)
    return values;
  values.resize(n_global_cells_);
  for (const auto& [ids, numbers] : parts)
    for (std::size_t i = 0; i < ids.size(); ++i)
      for (unsigned v = 0; v < 4; ++v)
        values[ids[i]][v] = Point<3>(numbers[12 * i + 3 * v], numbers[12 * i + 3 * v + 1],
                                     numbers[12 * i + 3 * v + 2]);
  return values;
}

} // namespace prosup::mechanics
