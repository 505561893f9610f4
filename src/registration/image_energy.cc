#include "image_energy.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "prosup/mechanics/body/cell_edges.h"

namespace prosup::registration {

using namespace dealii;
using mechanics::cell_edges;
using mechanics::NodeVector;
using similarity::prone;
using similarity::supine;

namespace {

constexpr std::array<State, 2> both{prone, supine};
constexpr double linear_tolerance = 1e-2;

/// Smallest J = det dx/dX of a cell; 0 if one is inverted.
double smallest_jacobian_of(const mechanics::Body& body, const NodeVector& unloaded) {
  double smallest = std::numeric_limits<double>::max();
  for (const auto& cell : body.cells()) {
    const double V = determinant(cell_edges(cell, unloaded)),
                 v = determinant(cell_edges(cell, body.vertex_positions()));
    smallest = std::min(smallest, V > 0. ? v / V : 0.);
  }
  return smallest;
}

} // namespace

void add(StateVectors& to, double factor, const StateVectors& what) {
  for (const State s : both)
    if (what[s].size() > 0)
      to[s].add(factor, what[s]);
}

StateVectors ImageEnergyPoint::descent(double kappa) const {
  StateVectors force = similarity.forces;
  for (NodeVector& part : force)
    part *= kappa;
  add(force, -1., elastic_force);
  return force;
}

ImageEnergy::ImageEnergy(BodyPair& pair, const SimilaritySetup& setup, double smallest_jacobian)
    : pair_(pair), setup_(setup), smallest_jacobian_(smallest_jacobian) {
  pair_.for_each([&](State which, BodyState& state) {
    start_[which] = state.unloading->unloaded();
    start_[which].update_ghost_values();
    state.supports->contacts().put_on_surfaces(start_[which]);
    metric_[which] =
        std::make_unique<mechanics::ElasticMetric>(*state.supports, state.material, start_[which]);
  });
}

void ImageEnergy::set_level(const similarity::Scene& scene, double level) {
  domain_ = setup_.domain(pair_, scene, level);
  images_ = setup_.images(pair_, level);
}

ImageEnergyPoint ImageEnergy::evaluate(StateVectors unloaded, bool with_stiffness) const {
  ImageEnergyPoint point;
  point.unloaded = std::move(unloaded);
  std::array<similarity::LoadedState, 2> states = pair_.loaded_states(images_);
  std::array<double, 2> energy{};
  double jacobian = std::numeric_limits<double>::max();
  pair_.for_each([&](State which, BodyState& state) {
    NodeVector& X = point.unloaded[which];
    X.update_ghost_values();
    state.supports->contacts().put_on_surfaces(X);
    states[which].unloaded = &X;
    jacobian = std::min(jacobian, smallest_jacobian_of(*state.body, X));
    NodeVector way = X;
    way -= start_[which];
    NodeVector& force = point.elastic_force[which];
    state.body->initialize(force);
    metric_[which]->multiply(way, force);
    energy[which] = 0.5 * (force * way);
  });
  point.elastic_energy = sum_of_states(energy);
  point.is_allowed = Utilities::MPI::min(jacobian, pair_.ranks().world()) > smallest_jacobian_;
  if (point.is_allowed)
    point.similarity =
        setup_.force().evaluate(domain_, states, similarity::Variable::unloaded, with_stiffness);
  return point;
}

StateVectors ImageEnergy::solve(const ImageStiffness& stiffness, double factor,
                                const StateVectors& force) const {
  StateVectors solution;
  pair_.for_each([&](State which, BodyState&) {
    metric_[which]->solve(stiffness[which], factor, force[which], linear_tolerance,
                          solution[which]);
  });
  return solution;
}

double ImageEnergy::product(const StateVectors& a, const StateVectors& b) const {
  std::array<double, 2> products{};
  pair_.for_each([&](State which, BodyState&) { products[which] = a[which] * b[which]; });
  return sum_of_states(products);
}

double ImageEnergy::sum_of_states(const std::array<double, 2>& values) const {
  const RankSplit& ranks = pair_.ranks();
  const int rank = Utilities::MPI::this_mpi_process(ranks.world());
  double sum = 0.;
  for (const State s : both)
    if (ranks.holds(s) && rank == ranks.first_rank(s))
      sum += values[s];
  return Utilities::MPI::sum(sum, ranks.world());
}

} // namespace prosup::registration
