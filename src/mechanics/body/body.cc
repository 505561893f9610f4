#include "prosup/mechanics/body/body.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <algorithm>
#include <numeric>

#include "prosup/core/collective.h"
#include "prosup/core/error.h"
#include "prosup/core/tet_topology.h"

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

/// Reorders a list that has `n` values for each item.
template <typename T>
void reorder(std::vector<T>& values, const std::vector<unsigned>& order, unsigned n = 1) {
  std::vector<T> reordered;
  reordered.reserve(values.size());
  for (const unsigned item : order)
    reordered.insert(reordered.end(), values.begin() + std::size_t(n) * item,
                     values.begin() + std::size_t(n) * (item + 1));
  values.swap(reordered);
}

} // namespace

Body::Body(const Triangulation<3>& triangulation, Element element)
    : communicator_(triangulation.get_communicator()), element_(element) {
  if (!triangulation.all_reference_cells_are_simplex())
    throw Error(
        "The mesh of a body has cells that are no tetrahedra; only tetrahedral meshes are "
        "allowed, so convert the others (GridGenerator::convert_hypercube_to_simplex_mesh).");
  n_global_elements_ = triangulation.n_global_active_cells();
  number_nodes(triangulation);
  sort_elements();
  list_cells();
}

void Body::number_nodes(const Triangulation<3>& triangulation) {
  const FE_SimplexP<3> shape(element_.degree());
  DoFHandler<3> nodes(triangulation);
  nodes.distribute_dofs(shape);
  DoFRenumbering::Cuthill_McKee(nodes);

  IndexSet active;
  DoFTools::extract_locally_active_dofs(nodes, active);
  const IndexSet owned = three_per_node(nodes.locally_owned_dofs());
  partitioner_ =
      std::make_shared<Utilities::MPI::Partitioner>(owned, three_per_node(active), communicator_);
  n_owned_nodes_ = nodes.n_locally_owned_dofs();
  n_local_nodes_ = n_owned_nodes_ + partitioner_->n_ghost_indices() / 3;
  initialize(vertex_positions_);

  const auto add = [&](types::global_dof_index node, const Point<3>& position,
                       std::vector<unsigned>& list) {
    const unsigned local = partitioner_->global_to_local(3 * node) / 3;
    for (unsigned c = 0; c < 3; ++c)
      vertex_positions_.local_element(3 * local + c) = position[c];
    list.push_back(local);
  };
  for (const auto& cell : nodes.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    for (unsigned v = 0; v < 4; ++v)
      add(cell->vertex_dof_index(v, 0), cell->vertex(v), element_nodes_);
    if (element_.degree() == 2)
      for (unsigned e = 0; e < 6; ++e)
        add(cell->line(e)->dof_index(0), cell->line(e)->center(), element_nodes_);
    material_ids_.push_back(cell->material_id());
    mesh_cells_.push_back(cell->id().get_coarse_cell_id());
    for (const unsigned f : cell->face_indices())
      if (cell->face(f)->at_boundary()) {
        const auto face = cell->face(f);
        BoundaryFace& boundary = boundary_faces_.emplace_back();
        boundary.id = face->boundary_id();
        for (unsigned v = 0; v < 3; ++v)
          add(face->vertex_dof_index(v, 0), face->vertex(v), boundary.nodes);
        if (element_.degree() == 2)
          for (unsigned e = 0; e < 3; ++e)
            add(face->line(e)->dof_index(0), face->line(e)->center(), boundary.nodes);
      }
  }
  vertex_positions_.update_ghost_values();
}

void Body::sort_elements() {
  const unsigned n = element_.n_nodes();
  std::vector<unsigned> order(n_elements());
  std::iota(order.begin(), order.end(), 0u);
  const auto is_interior = [&](unsigned element) {
    return *std::max_element(element_nodes(element), element_nodes(element) + n) < n_owned_nodes_;
  };
  const auto first_node = [&](unsigned element) {
    return *std::min_element(element_nodes(element), element_nodes(element) + n);
  };
  std::stable_sort(order.begin(), order.end(), [&](unsigned a, unsigned b) {
    return std::make_pair(is_interior(a), first_node(a)) <
           std::make_pair(is_interior(b), first_node(b));
  });
  reorder(element_nodes_, order, n);
  reorder(material_ids_, order);
  reorder(mesh_cells_, order);
}

void Body::list_cells() {
  for (unsigned e = 0; e < n_elements(); ++e) {
    const unsigned* nodes = element_nodes(e);
    if (element_.degree() == 1) {
      cells_.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
      cell_ids_.push_back(mesh_cells_[e]);
      continue;
    }
    for (unsigned c = 0; c < tet_children.size(); ++c) {
      const auto& child = tet_children[c];
      cells_.push_back({nodes[child[0]], nodes[child[1]], nodes[child[2]], nodes[child[3]]});
      cell_ids_.push_back(8 * mesh_cells_[e] + c);
    }
  }
}

void Body::initialize(NodeVector& vector) const {
  vector.reinit(partitioner_);
}

std::vector<std::array<Point<3>, 4>> Body::gather_at_cells(const NodeVector& vector) const {
  std::vector<std::array<Point<3>, 4>> part(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i)
    for (unsigned v = 0; v < 4; ++v)
      part[i][v] = Point<3>(node_value(vector, cells_[i][v]));

  const int rank = static_cast<int>(Utilities::MPI::this_mpi_process(communicator_)),
            n_ranks = static_cast<int>(Utilities::MPI::n_mpi_processes(communicator_));
  std::vector<std::array<Point<3>, 4>> values(rank == 0 ? n_global_cells() : 0);
  std::vector<unsigned> ids = cell_ids_;
  for (int from = 0; from < n_ranks; ++from) {
    if (rank == 0 || rank == from) {
      transfer(ids, from, 0, communicator_);
      transfer(part, from, 0, communicator_);
    }
    for (std::size_t i = 0; rank == 0 && i < ids.size(); ++i)
      values[ids[i]] = part[i];
  }
  return values;
}

std::vector<double> sum_over_ranks(const Body& body, const std::vector<double>& at_local_nodes) {
  NodeVector sum;
  body.initialize(sum);
  for (unsigned node = 0; node < body.n_local_nodes(); ++node)
    sum.local_element(3 * node) = at_local_nodes[node];
  sum.compress(VectorOperation::add);
  sum.update_ghost_values();
  std::vector<double> result(body.n_local_nodes());
  for (unsigned node = 0; node < body.n_local_nodes(); ++node)
    result[node] = sum.local_element(3 * node);
  return result;
}

} // namespace prosup::mechanics
