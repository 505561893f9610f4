// Sliding nodes that keep a body from settling.

#include <deal.II/base/mpi.h>

#include <algorithm>

#include "prosup/mesh/tet_mesh.h"
#include "simulation.h"

namespace prosup::unloading {

using namespace dealii;
using mechanics::node_value;

namespace {

// Those are meant whose error is more than this part of the largest, and more than all others are
// within their tolerance when they are gone.
constexpr double part_of_largest = 0.25;

// More than these parts of the sliding nodes, at once and in all, are no exception but the body.
constexpr double most_at_once = 0.03, most_in_all = 0.06;
constexpr unsigned few = 6; // are always an exception

constexpr auto chest_wall = mesh::boundary_id_of(mesh::BoundaryPart::chest_wall);

} // namespace

void Unloading::Simulation::hold(const std::vector<bool>& nodes) {
  held_.resize(body_.n_local_nodes(), false);
  for (unsigned node = 0; node < held_.size(); ++node)
    held_[node] = held_[node] || nodes[node];
  supports_.hold(held_);
  integrator_.update_fixed();
}

/// Holds the sliding nodes that jump to and fro while all others have settled, where they are in
/// the state to which the simulation returns: as if they stuck to the chest by friction.
settling::Remedy Unloading::Simulation::hold_stalled_nodes() {
  const unsigned n_owned = body_.n_owned_nodes();
  std::vector<bool> slides(n_owned, false);
  for (const auto& contact : supports_.contacts().nodes())
    if (contact.node < n_owned)
      slides[contact.node] = true;
  const double limit = part_of_largest * max_distance();
  std::vector<double> stalled(body_.n_local_nodes(), 0.);
  double sums[7] = {}; // sliding, stalled, stalled that slide, held before, centre of the third
  for (unsigned node = 0; node < n_owned; ++node) {
    const Tensor<1, 3> loaded = node_value(body_.vertex_positions(), node);
    const double distance =
        (loaded - node_value(state_.displacement, node) - node_value(state_.unloaded, node)).norm();
    sums[0] += slides[node];
    sums[1] += distance > limit;
    sums[3] += !held_.empty() && held_[node];
    if (distance > limit && slides[node]) {
      stalled[node] = 1.;
      sums[2] += 1.;
      for (unsigned c = 0; c < 3; ++c)
        sums[4 + c] += loaded[c];
    }
  }
  Utilities::MPI::sum(ArrayView<const double>(sums, 7), body_.communicator(),
                      ArrayView<double>(sums, 7));
  const double n = sums[2];
  if (n == 0. || sums[1] > std::max<double>(few, most_at_once * sums[0]) ||
      n + sums[3] > std::max<double>(few, most_in_all * (sums[0] + sums[3])))
    return {};
  stalled = mechanics::sum_over_ranks(body_, stalled);
  std::vector<bool> nodes(stalled.size());
  std::transform(stalled.begin(), stalled.end(), nodes.begin(), [](double s) { return s > 0.; });
  hold(nodes);
  const std::string which =
      format("%.0f of %.0f nodes that slide on the chest of %s, near (%.0f, %.0f, %.0f) mm", n,
             sums[0], name_.c_str(), sums[4] / n, sums[5] / n, sums[6] / n);
  remarks_.push_back("The other nodes settled but not " + which +
                     ", which were held there; look at the chest label at that place, or smooth it "
                     "with 'Supports/Chest smoothing'.");
  return {which + ", held", true};
}

/// Holds all nodes that slide on a chest: a breast that cannot be unloaded sliding may be so on a
/// fixed chest.
settling::Remedy Unloading::Simulation::hold_chest() {
  std::vector<bool> sliding(body_.n_local_nodes(), false);
  for (const auto& contact : supports_.contacts().nodes())
    if (supports_.contacts().surfaces()[contact.contact].ids.count(chest_wall) > 0)
      sliding[contact.node] = true;
  const bool any = std::find(sliding.begin(), sliding.end(), true) != sliding.end();
  if (Utilities::MPI::max(static_cast<int>(any), body_.communicator()) == 0)
    return {};
  hold(sliding);
  holds_chest_ = true;
  remarks_ = {"The " + name_ +
              " breast did not settle while it slid on its chest, which is therefore taken as "
              "fixed; check the chest label, or raise 'Supports/Chest stiffness'."};
  return {"all of the chest held", true, true};
}

/// Sliding was tried first, if it was asked for, and then the chest was held, so that neither would
/// help.
std::string Unloading::Simulation::advice() const {
  const std::string place =
      "or cut from the mask what hangs there on a thin neck or lies in a fold";
  if (holds_chest_)
    return "it does not settle with the chest held either, so the breast is too soft for its "
           "weight: raise 'Material/Shear modulus', " +
           place;
  return "raise 'Material/Shear modulus' if all of the breast gives way, " + place;
}

} // namespace prosup::unloading
