#include "collapse_watch.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

#include "prosup/core/log.h"
#include "prosup/settling/simulation.h"

namespace prosup::unloading {

using namespace dealii;

namespace {

std::string describe(const mechanics::InternalForce::WorstCell& worst, double jacobian) {
  return format("cell %u near (%.1f, %.1f, %.1f) mm with J = %.2g", worst.cell, worst.centre[0],
                worst.centre[1], worst.centre[2], jacobian);
}

} // namespace

void CollapseWatch::restart() {
  n_steps_ = 0;
  min_jacobian_ = std::numeric_limits<double>::max();
  collapsed_cell_.clear();
}

void CollapseWatch::look(double min_jacobian, const mechanics::NodeVector& displacement) {
  ++n_steps_;
  min_jacobian_ = std::min(min_jacobian_, min_jacobian);
  if (min_jacobian > settling::smallest_healthy_jacobian || !collapsed_cell_.empty())
    return;
  first_collapse_ = n_steps_;
  collapsed_cell_ =
      describe(internal_force_.worst_cell(body_.vertex_positions(), displacement), min_jacobian);
}

std::string CollapseWatch::worst_cell(const mechanics::NodeVector& displacement) const {
  constexpr double never = std::numeric_limits<double>::max();
  const MPI_Comm communicator = body_.communicator();
  const auto worst_of_ranks = [&](double order, const std::string& text) -> std::string {
    const auto orders = Utilities::MPI::all_gather(communicator, order);
    const auto texts = Utilities::MPI::all_gather(communicator, text);
    const auto first = std::min_element(orders.begin(), orders.end());
    return *first < never ? texts[first - orders.begin()] : "";
  };
  const std::string collapsed =
      worst_of_ranks(collapsed_cell_.empty() ? never : first_collapse_, collapsed_cell_);
  if (!collapsed.empty())
    return collapsed;
  const auto worst = internal_force_.worst_cell(body_.vertex_positions(), displacement);
  return worst_of_ranks(worst.jacobian, describe(worst, worst.jacobian));
}

} // namespace prosup::unloading
