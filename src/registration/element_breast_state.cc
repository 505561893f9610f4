// What a breast of elements goes on from, whatever the number of ranks.

#include <deal.II/base/mpi.h>

#include <limits>

#include "prosup/core/collective.h"
#include "prosup/registration/element_breast.h"

namespace prosup::registration {

using mechanics::NodeVector;

namespace {

constexpr unsigned nowhere = std::numeric_limits<unsigned>::max();

} // namespace

const std::vector<unsigned>& ElementBreast::node_numbers() const {
  if (!node_numbers_.empty())
    return node_numbers_;
  std::vector<std::array<unsigned, 4>> cells = parts_.mesh.cells;
  cells.resize(body().n_global_cells());
  MPI_Bcast(cells.data(), static_cast<int>(4 * cells.size()), MPI_UNSIGNED, 0,
            body().communicator());
  node_numbers_.assign(body().n_local_nodes(), nowhere);
  for (std::size_t cell = 0; cell < body().cells().size(); ++cell)
    for (unsigned a = 0; a < 4; ++a)
      node_numbers_[body().cells()[cell][a]] = cells[body().cell_ids()[cell]][a];
  return node_numbers_;
}

std::vector<double> ElementBreast::rows_of(const NodeVector& field) const {
  return {field.begin(), field.begin() + 3 * static_cast<std::size_t>(body().n_owned_nodes())};
}

NodeVector ElementBreast::field_of(const std::vector<unsigned>& nodes,
                                   const std::vector<double>& rows) const {
  NodeVector field;
  body().initialize(field);
  on_every_rank(body().communicator(), [&] {
    std::vector<std::size_t> row_of_node;
    for (std::size_t row = 0; row < nodes.size(); ++row) {
      if (nodes[row] >= row_of_node.size())
        row_of_node.resize(nodes[row] + 1, nowhere);
      row_of_node[nodes[row]] = row;
    }
    for (unsigned node = 0; node < body().n_owned_nodes(); ++node) {
      const unsigned number = node_numbers_[node];
      const std::size_t row = number < row_of_node.size() ? row_of_node[number] : nowhere;
      if (3 * row + 2 >= rows.size())
        throw Error(format("The state of the %s breast lacks its node %u; it belongs to another "
                           "mesh, so run the simulation again.",
                           name_of(position_), number));
      for (unsigned c = 0; c < 3; ++c)
        field.local_element(3 * node + c) = rows[3 * row + c];
    }
  });
  field.update_ghost_values();
  return field;
}

BreastState ElementBreast::state() const {
  BreastState state;
  state.mesh = parts_.coarse.cells.empty() ? parts_.mesh : parts_.coarse;
  const std::vector<unsigned>& numbers = node_numbers();
  state.nodes.assign(numbers.begin(), numbers.begin() + body().n_owned_nodes());
  const mechanics::NodeMemory memory = unloading().memory();
  for (const auto& [name, field] : memory.fields)
    state.fields[name] = rows_of(field);
  state.numbers = memory.numbers;
  return state;
}

void ElementBreast::resume(const BreastState& state) {
  node_numbers();
  mechanics::NodeMemory memory;
  for (const auto& [name, rows] : state.fields)
    memory.fields[name] = field_of(state.nodes, rows);
  memory.numbers = state.numbers;
  unloading().recall(memory);
  is_loaded_ = memory.number("holds_reference") > 0.;
}

} // namespace prosup::registration
