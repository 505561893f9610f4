#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "prosup/mechanics/cell_edges.h"
#include "prosup/mechanics/elastic_metric.h"
#include "prosup/registration/image_force_registration.h"

namespace prosup::registration {

using namespace dealii;
using mechanics::cell_edges;
using mechanics::NodeVector;
using similarity::prone;
using similarity::SimilarityDomain;
using similarity::supine;

namespace {

constexpr std::array<State, 2> both{prone, supine};
constexpr double shortest_step = 0.05; // of a Gauss-Newton step
constexpr double linear_tolerance = 1e-2;

/// Smallest J = det dx/dX of a cell; 0 if one is inverted.
double smallest_jacobian(const mechanics::Body& body, const NodeVector& unloaded) {
  double smallest = std::numeric_limits<double>::max();
  for (const auto& cell : body.cells()) {
    const double V = determinant(cell_edges(cell, unloaded)),
                 v = determinant(cell_edges(cell, body.vertex_positions()));
    smallest = std::min(smallest, V > 0. ? v / V : 0.);
  }
  return smallest;
}

/// What is known of a pair of unloaded positions.
struct Point {
  std::array<NodeVector, 2> unloaded;      ///< X
  std::array<NodeVector, 2> elastic_force; ///< K (X - X0)
  double energy = 0.;                      ///< 1/2 (X - X0)^T K (X - X0), both states
  bool is_allowed = false;                 ///< no element is near inversion
  similarity::SimilarityResult similarity; ///< if allowed

  double objective(double kappa) const { return kappa * similarity.value + energy; }
};

} // namespace

/// The updates on one image level.
class ImageForceRegistration::GaussNewton {
public:
  GaussNewton(const ImageForceRegistration& parameters, BodyPair& pair,
              const SimilaritySetup& setup, const Log& log, const Observer& observer)
      : parameters_(parameters), pair_(pair), setup_(setup), log_(log), observer_(observer) {
    pair_.for_each([&](State which, BodyState& state) {
      start_[which] = state.unloading->unloaded();
      start_[which].update_ghost_values();
      state.supports->put_on_surfaces(start_[which]);
      metric_[which] = std::make_unique<mechanics::ElasticMetric>(*state.supports, state.material,
                                                                  start_[which]);
    });
  }

  /// Updates until nothing more is gained; the pair has the last good state.
  unsigned run(const similarity::Scene& scene, double level) {
    domain_ = setup_.domain(pair_, scene, level);
    images_ = setup_.images(pair_, level);
    std::array<NodeVector, 2> present;
    pair_.for_each(
        [&](State which, BodyState& state) { present[which] = state.unloading->unloaded(); });
    Point point = evaluate(std::move(present));
    report(level, 0, 0., point);
    unsigned n_updates = 0;
    double gained = 0.;
    while (n_updates < parameters_.updates_per_level_ && point.is_allowed) {
      const double kappa = parameters_.image_weight_ * pair_.properties().tissue.shear_modulus /
                           point.similarity.residual_variance;
      const double before = point.objective(kappa);
      if (!std::isfinite(kappa) || !improve(point, kappa))
        break;
      pair_.for_each(
          [&](State which, BodyState& state) { state.unloading->adopt(point.unloaded[which]); });
      report(level, ++n_updates, kappa, point);
      const double gain = 1. - point.objective(kappa) / before;
      gained += gain;
      if (gain < parameters_.least_gain_ * gained)
        break;
    }
    log_.line(format("  level %g mm: %s %.4g after %u updates", level, setup_.metric().c_str(),
                     point.similarity.value, n_updates));
    return n_updates;
  }

private:
  /// Moves the point along the Gauss-Newton step, if that makes it better.
  bool improve(Point& point, double kappa) const {
    const std::array<NodeVector, 2> direction = step(point, kappa);
    for (double length = 1.; length > shortest_step; length *= 0.5) {
      std::array<NodeVector, 2> trial = point.unloaded;
      for (const State s : both)
        if (pair_.ranks().holds(s))
          trial[s].add(length, direction[s]);
      Point next = evaluate(std::move(trial));
      if (next.is_allowed && next.objective(kappa) < point.objective(kappa)) {
        point = std::move(next);
        return true;
      }
    }
    return false;
  }

  std::array<NodeVector, 2> step(const Point& point, double kappa) const {
    std::array<NodeVector, 2> step;
    pair_.for_each([&](State which, BodyState&) {
      NodeVector force = point.similarity.forces[which];
      force *= kappa;
      force -= point.elastic_force[which];
      metric_[which]->solve(point.similarity.stiffness[which], 2. * kappa, force, linear_tolerance,
                            step[which]);
    });
    return step;
  }

  Point evaluate(std::array<NodeVector, 2> unloaded) const {
    Point point;
    point.unloaded = std::move(unloaded);
    std::array<similarity::LoadedState, 2> states = pair_.loaded_states(images_);
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
      NodeVector& force = point.elastic_force[which];
      state.body->initialize(force);
      metric_[which]->multiply(way, force);
      energy[which] = 0.5 * (force * way);
    });
    point.energy = sum_of_states(energy);
    point.is_allowed =
        Utilities::MPI::min(jacobian, pair_.ranks().world()) > parameters_.smallest_jacobian_;
    if (point.is_allowed)
      point.similarity =
          setup_.force().evaluate(domain_, states, similarity::Variable::unloaded, true);
    return point;
  }

  double sum_of_states(const std::array<double, 2>& values) const {
    const RankSplit& ranks = pair_.ranks();
    const int rank = Utilities::MPI::this_mpi_process(ranks.world());
    double sum = 0.;
    for (const State s : both)
      if (ranks.holds(s) && rank == ranks.first_rank(s))
        sum += values[s];
    return Utilities::MPI::sum(sum, ranks.world());
  }

  void report(double level, unsigned update, double kappa, const Point& point) const {
    log_.progress(format("  image forces: level %g mm, update %u, weight %.0f Pa, %s %.4g", level,
                         update, kappa, setup_.metric().c_str(), point.similarity.value));
    if (observer_)
      observer_({"image_forces", level, update, kappa, point.similarity.value});
  }

  const ImageForceRegistration& parameters_;
  BodyPair& pair_;
  const SimilaritySetup& setup_;
  const Log& log_;
  const Observer& observer_;
  std::array<std::unique_ptr<mechanics::ElasticMetric>, 2> metric_;
  std::array<NodeVector, 2> start_; ///< X0
  SimilarityDomain domain_;
  std::array<image::ScalarImage, 2> images_;
};

void ImageForceRegistration::run_gauss_newton(BodyPair& pair, const SimilaritySetup& setup,
                                              const similarity::Scene& scene, const Log& log,
                                              const Observer& observer,
                                              ImageForceResult& result) const {
  GaussNewton steps(*this, pair, setup, log, observer);
  for (const double level : levels_)
    result.n_updates += steps.run(scene, level);
}

} // namespace prosup::registration
