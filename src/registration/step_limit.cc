#include "step_limit.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

#include "prosup/mechanics/body/cell_edges.h"

namespace prosup::registration {

using namespace dealii;
using mechanics::cell_edges;
using mechanics::NodeVector;

namespace {

constexpr unsigned n_halvings = 5, n_rounds = 20;

/// The volumes of the unloaded cells of this rank that are allowed, and the present ones.
struct CellVolumes {
  std::vector<double> low, high;

  CellVolumes(const mechanics::Body& body, const NodeVector& unloaded,
              const JacobianBounds& bounds) {
    for (const auto& cell : body.cells()) {
      const double loaded = determinant(cell_edges(cell, body.vertex_positions())),
                   present = determinant(cell_edges(cell, unloaded));
      low.push_back(std::min(loaded / bounds.largest, present));
      high.push_back(bounds.smallest > 0. ? std::max(loaded / bounds.smallest, present)
                                          : std::numeric_limits<double>::max());
    }
  }
};

void multiply(NodeVector& step, const NodeVector& factor) {
  for (unsigned i = 0; i < step.locally_owned_size(); ++i)
    step.local_element(i) *= factor.local_element(i);
  step.update_ghost_values();
}

} // namespace

double smallest_jacobian_of(const mechanics::Body& body, const NodeVector& unloaded) {
  double smallest = std::numeric_limits<double>::max();
  for (const auto& cell : body.cells()) {
    const double V = determinant(cell_edges(cell, unloaded)),
                 v = determinant(cell_edges(cell, body.vertex_positions()));
    smallest = std::min(smallest, V > 0. ? v / V : 0.);
  }
  return smallest;
}

void limit_step(const mechanics::Body& body, const NodeVector& unloaded,
                const JacobianBounds& bounds, NodeVector& step) {
  const CellVolumes volumes(body, unloaded, bounds);
  step.update_ghost_values();
  NodeVector trial = unloaded, factor;
  body.initialize(factor);
  for (unsigned round = 0; round < n_rounds; ++round) {
    for (unsigned i = 0; i < 3 * body.n_local_nodes(); ++i)
      trial.local_element(i) = unloaded.local_element(i) + step.local_element(i);
    factor.zero_out_ghost_values();
    std::fill_n(factor.begin(), 3 * body.n_local_nodes(), 0.);
    bool limits = false;
    for (std::size_t c = 0; c < body.cells().size(); ++c) {
      const double volume = determinant(cell_edges(body.cells()[c], trial));
      if (volume >= volumes.low[c] && volume <= volumes.high[c])
        continue;
      limits = true;
      for (const unsigned node : body.cells()[c])
        for (unsigned d = 0; d < 3; ++d)
          factor.local_element(3 * node + d) = 1.;
    }
    if (Utilities::MPI::max(int(limits), body.communicator()) == 0)
      return;
    // Counts on all ranks: any at all shortens the step of the node.
    factor.compress(VectorOperation::add);
    const double shortened = round < n_halvings ? 0.5 : 0.;
    for (unsigned i = 0; i < factor.locally_owned_size(); ++i)
      factor.local_element(i) = factor.local_element(i) > 0. ? shortened : 1.;
    multiply(step, factor);
  }
}

} // namespace prosup::registration
