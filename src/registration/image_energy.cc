#include "image_energy.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "prosup/registration/element_breast.h"

namespace prosup::registration {

using namespace dealii;
using mechanics::NodeVector;

namespace {

constexpr double linear_tolerance = 1e-2;

} // namespace

void add(PairVectors& to, double factor, const PairVectors& what) {
  for (const Position position : both_positions)
    if (what[position].size() > 0)
      to[position].add(factor, what[position]);
}

void scale(PairVectors& vectors, double factor) {
  for (const Position position : both_positions)
    vectors[position] *= factor;
}

PairVectors ImageEnergyPoint::descent(double kappa) const {
  PairVectors force = similarity.forces;
  scale(force, kappa);
  add(force, -1., elastic_force);
  return force;
}

ImageEnergy::ImageEnergy(const BreastPair& pair, const JacobianBounds& bounds,
                         const PairVectors& start)
    : pair_(pair), bounds_(bounds) {
  pair_.for_each([&](Position position, Breast& breast) {
    ElementBreast& elements = *breast.elements();
    const bool is_given = start[position].size() > 0;
    start_[position] = is_given ? start[position] : elements.unloading().unloaded();
    start_[position].update_ghost_values();
    elements.supports().set_reference(start_[position]); // springs act on areas at X0
    elements.supports().contacts().put_on_surfaces(start_[position]);
    metric_[position] = std::make_unique<mechanics::ElasticMetric>(
        elements.supports(), elements.material(), start_[position]);
    elements.supports().set_reference(elements.unloading().unloaded()); // as the simulation had it
  });
}

void ImageEnergy::compare_by(const Comparison& comparison) {
  comparison_ = &comparison;
  image_force_ =
      std::make_unique<similarity::ImageForce>(comparison.metric(), pair_.ranks().world());
}

ImageEnergyPoint ImageEnergy::evaluate(PairVectors unloaded, bool with_stiffness) const {
  ImageEnergyPoint point;
  point.unloaded = std::move(unloaded);
  PerPosition<similarity::ImagedBody> bodies;
  PerPosition<double> energy;
  double jacobian = std::numeric_limits<double>::max();
  pair_.for_each([&](Position position, Breast& breast) {
    ElementBreast& elements = *breast.elements();
    NodeVector& X = point.unloaded[position];
    X.update_ghost_values();
    elements.supports().contacts().put_on_surfaces(X);
    bodies[position] = {&elements.body(), &X, &comparison_->images()[position]};
    jacobian = std::min(jacobian, smallest_jacobian_of(elements.body(), X));
    NodeVector way = X;
    way -= start_[position];
    NodeVector& force = point.elastic_force[position];
    elements.body().initialize(force);
    metric_[position]->multiply(way, force);
    energy[position] = 0.5 * (force * way);
  });
  point.elastic_energy = sum_over_breasts(energy);
  point.is_allowed = Utilities::MPI::min(jacobian, pair_.ranks().world()) > bounds_.smallest;
  if (point.is_allowed)
    point.similarity = image_force_->evaluate(comparison_->domain(), bodies,
                                              similarity::Variable::unloaded, with_stiffness);
  return point;
}

PairVectors ImageEnergy::moved(const PairVectors& from, double length,
                               const PairVectors& direction) const {
  PairVectors to = from;
  pair_.for_each([&](Position position, Breast& breast) {
    NodeVector step = direction[position];
    step *= length;
    from[position].update_ghost_values();
    limit_step(breast.elements()->body(), from[position], bounds_, step);
    to[position] += step;
  });
  return to;
}

PairVectors ImageEnergy::solve(const ImageStiffness& stiffness, double factor,
                               const PairVectors& force) const {
  PairVectors solution;
  pair_.for_each([&](Position position, Breast&) {
    metric_[position]->solve(stiffness[position], factor, force[position], linear_tolerance,
                             solution[position]);
  });
  return solution;
}

double ImageEnergy::product(const PairVectors& a, const PairVectors& b) const {
  PerPosition<double> products;
  pair_.for_each(
      [&](Position position, Breast&) { products[position] = a[position] * b[position]; });
  return sum_over_breasts(products);
}

double ImageEnergy::distance(const ImageEnergyPoint& point) const {
  PerPosition<double> squares, n_numbers;
  pair_.for_each([&](Position position, Breast&) {
    NodeVector way = point.unloaded[position];
    way -= start_[position];
    squares[position] = way * way;
    n_numbers[position] = static_cast<double>(way.size());
  });
  return std::sqrt(3. * sum_over_breasts(squares) / sum_over_breasts(n_numbers));
}

double ImageEnergy::sum_over_breasts(const PerPosition<double>& values) const {
  const RankSplit& ranks = pair_.ranks();
  const int rank = Utilities::MPI::this_mpi_process(ranks.world());
  double sum = 0.;
  for (const Position position : both_positions)
    if (ranks.holds(position) && rank == ranks.first_rank(position))
      sum += values[position];
  return Utilities::MPI::sum(sum, ranks.world());
}

} // namespace prosup::registration
