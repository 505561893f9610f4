#include "gauss_newton.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace prosup::registration {

using namespace dealii;
using mechanics::node_value;
using mechanics::NodeVector;
using similarity::prone;
using similarity::supine;

namespace {

constexpr std::array<State, 2> both{prone, supine};

double volume(const std::array<unsigned, 4>& nodes, const NodeVector& positions) {
  const Tensor<1, 3> origin = node_value(positions, nodes[0]);
  return cross_product_3d(node_value(positions, nodes[1]) - origin,
                          node_value(positions, nodes[2]) - origin) *
         (node_value(positions, nodes[3]) - origin) / 6.;
}

double smallest_jacobian(const mechanics::Body& body, const NodeVector& unloaded) {
  double smallest = std::numeric_limits<double>::max();
  for (const auto& cell : body.cells()) {
    const double V = volume(cell, unloaded);
    smallest = std::min(smallest, V > 0. ? volume(cell, body.vertex_positions()) / V : 0.);
  }
  return smallest;
}

} // namespace

GaussNewton::GaussNewton(const GaussNewtonParameters& parameters, BodyPair& pair,
                         const SimilaritySetup& setup, const Log& log)
    : parameters_(parameters), pair_(pair), setup_(setup), log_(log) {
  pair_.for_each([&](State which, BodyState& state) {
    start_[which] = state.unloading->unloaded();
    start_[which].update_ghost_values();
    state.supports->put_on_surfaces(start_[which]);
    metric_[which] = std::make_unique<mechanics::ElasticMetric>(*state.supports, state.material,
                                                                start_[which]);
  });
  present_ = start_;
}

double GaussNewton::sum_of_states(const std::array<double, 2>& values) const {
  double sum = 0.;
  const int rank = Utilities::MPI::this_mpi_process(pair_.ranks().world());
  for (const State s : both)
    if (pair_.ranks().holds(s) && rank == pair_.ranks().first_rank(s))
      sum += values[s];
  return Utilities::MPI::sum(sum, pair_.ranks().world());
}

GaussNewton::Point GaussNewton::evaluate(const similarity::SimilarityDomain& domain,
                                         const std::array<image::ScalarImage, 2>& images,
                                         Positions unloaded) const {
  Point point;
  point.unloaded = std::move(unloaded);
  std::array<similarity::LoadedState, 2> states = pair_.loaded_states(images);
  std::array<double, 2> energy{};
  double jacobian = std::numeric_limits<double>::max();
  pair_.for_each([&](State which, BodyState& state) {
    NodeVector& X = point.unloaded[which];
    X.update_ghost_values();
    state.supports->put_on_surfaces(X);
    states[which].unloaded = &X;
    jacobian = std::min(jacobian, smallest_jacobian(*state.body, X));
    NodeVector way = X;
    way -= start_[which];
    state.body->initialize(point.elastic_force[which]);
    metric_[which]->multiply(way, point.elastic_force[which]);
    energy[which] = 0.5 * (point.elastic_force[which] * way);
  });
  point.min_jacobian = Utilities::MPI::min(jacobian, pair_.ranks().world());
  point.energy = sum_of_states(energy);
  if (point.min_jacobian > parameters_.smallest_jacobian)
    point.similarity = setup_.force().evaluate(domain, states, similarity::Variable::unloaded, true);
  return point;
}

GaussNewton::Positions GaussNewton::step(const Point& point, double kappa) const {
  Positions step;
  pair_.for_each([&](State which, BodyState&) {
    NodeVector force = point.similarity.forces[which];
    force *= kappa;
    if (!parameters_.free_anchor)
    force -= point.elastic_force[which];
    const unsigned n = metric_[which]->solve(point.similarity.stiffness[which], 2. * kappa, force, parameters_.tolerance,
                          step[which]);
    if (which == prone) log_.line(format("cg %u", n));
  });
  return step;
}

void GaussNewton::run_level(const similarity::Scene& scene, double level, double shear_modulus,
                            std::vector<SimilarityRecord>& history) {
  const auto domain = setup_.domain(pair_, scene, level);
  const auto images = setup_.images(pair_, level);
  Point point = evaluate(domain, images, present_);
  history.push_back({"image_forces", level, 0, 0., 0., point.similarity.value});
  for (unsigned i = 1; i <= parameters_.max_updates; ++i) {
    const double kappa =
        parameters_.weight * shear_modulus / point.similarity.residual_variance;
    const double anchor = parameters_.free_anchor ? 0. : 1.;
    const double before = kappa * point.similarity.value + anchor*point.energy;
    const Positions direction = step(point, kappa);
    Point next;
    double length = 1., after = 0.;
    for (; length > 0.05; length *= 0.5) {
      Positions trial = point.unloaded;
      for (const State s : both)
        if (pair_.ranks().holds(s))
          trial[s].add(length, direction[s]);
      next = evaluate(domain, images, std::move(trial));
      after = kappa * next.similarity.value + anchor * next.energy;
      if (next.min_jacobian > parameters_.smallest_jacobian && after < before)
        break;
    }
    if (!(length > 0.05))
      break;
    point = std::move(next);
    history.push_back({"image_forces", level, i, 0., kappa, point.similarity.value});
    log_.line(format("  image forces: level %g mm, update %u, weight %.0f Pa, S %.1f, rms %.4f, energy %.3g, length %g, phi %g, J %.2f",
                         level, i, kappa, point.similarity.value,
                         std::sqrt(point.similarity.residual_variance), point.energy, length, after, point.min_jacobian));
    if (before - after < parameters_.least_gain * before)
      break;
  }
  present_ = point.unloaded;
}

void GaussNewton::finish() {
  pair_.for_each(
      [&](State which, BodyState& state) { state.unloading->adopt(present_[which]); });
}

} // namespace prosup::registration
