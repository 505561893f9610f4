#include "prosup/mechanics/explicit/critical_step.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace prosup::mechanics {

using namespace dealii;

namespace {

constexpr unsigned max_products = 60;
// Of a first call: a rough start may rest for some products on an eigenvalue just
// below the top, with a small residual.
constexpr unsigned least_products_at_first = 16;
// What a new start keeps of the first one, lest it misses another top.
constexpr double part_of_rough = 0.1;

/// Largest eigenvalue of the symmetric tridiagonal matrix of Lanczos' method,
/// with the last entry of its eigenvector, and the eigenvector.
struct RitzPair {
  double value = 0.;
  std::vector<double> vector;

  RitzPair(const std::vector<double>& diagonal, const std::vector<double>& off_diagonal) {
    const unsigned n = diagonal.size();
    LAPACKFullMatrix<double> T(n);
    for (unsigned i = 0; i < n; ++i) {
      T(i, i) = diagonal[i];
      if (i + 1 < n)
        T(i, i + 1) = T(i + 1, i) = off_diagonal[i];
    }
    double bound = 0.; // of all eigenvalues
    for (unsigned i = 0; i < n; ++i)
      bound = std::max(bound, std::abs(diagonal[i]) + (i > 0 ? off_diagonal[i - 1] : 0.) +
                                  (i + 1 < n ? off_diagonal[i] : 0.));
    Vector<double> eigenvalues;
    FullMatrix<double> eigenvectors;
    T.compute_eigenvalues_symmetric(-2. * bound, 2. * bound, 0., eigenvalues, eigenvectors);
    const unsigned top = eigenvalues.size() - 1;
    value = eigenvalues[top];
    for (unsigned i = 0; i < n; ++i)
      vector.push_back(eigenvectors(i, top));
  }
};

/// Rough, and the same for every partition: from the positions of the nodes.
double rough_number(const Tensor<1, 3>& position, unsigned component) {
  const double phase = position * Tensor<1, 3>({12.9898, 78.233, 37.719}) + 1.7 * component;
  return std::sin(43.758 * phase);
}

} // namespace

double HighestFrequency::Estimate::critical_step(double added) const {
  return 2. / std::sqrt(upper_bound + added);
}

HighestFrequency::HighestFrequency(const Body& body, const InternalForce& internal_force)
    : body_(body), internal_force_(internal_force) {
  body.initialize(rough_);
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    for (unsigned c = 0; c < 3; ++c)
      rough_.local_element(3 * node + c) =
          rough_number(node_value(body.vertex_positions(), node), c);
  rough_ *= 1. / rough_.l2_norm();
  start_ = rough_;
}

void HighestFrequency::store(NodeMemory& memory) const {
  memory.fields["highest_mode"] = start_;
  memory.numbers["has_highest_mode"] = has_found_top_ ? 1. : 0.;
}

void HighestFrequency::recall(const NodeMemory& memory) {
  start_ = memory.field("highest_mode");
  has_found_top_ = memory.number("has_highest_mode") > 0.;
}

/// K v = (f(u + e v) - f(u - e v)) / 2e.
NodeVector HighestFrequency::product(const NodeVector& displacement,
                                     const NodeVector& direction) const {
  const double largest = direction.linfty_norm();
  // Small against an element, large against rounding in single precision.
  const double step = largest > 0. ? 1e-3 / largest : 1.;
  NodeVector moved, result;
  body_.initialize(moved);
  body_.initialize(result);
  const auto add = [&](double sign) {
    for (unsigned i = 0; i < 3 * body_.n_owned_nodes(); ++i)
      moved.local_element(i) =
          displacement.local_element(i) + sign * step * direction.local_element(i);
    internal_force_.subtract(moved, result);
    moved.zero_out_ghost_values();
  };
  add(-1.);
  result *= -1.; // now plus the force at u - e v
  add(1.);
  result *= -0.5 / step;
  return result;
}

HighestFrequency::Estimate HighestFrequency::estimate(const NodeVector& displacement,
                                                      const std::vector<double>& mass,
                                                      const std::vector<bool>& fixed,
                                                      double tolerance) {
  const unsigned n = 3 * body_.n_owned_nodes();
  std::vector<double> to_velocity(n); // M^-1/2, 0 at fixed nodes
  for (unsigned i = 0; i < n; ++i)
    to_velocity[i] = fixed[i / 3] ? 0. : 1. / std::sqrt(mass[i / 3]);
  const auto scaled = [&](const NodeVector& v) {
    NodeVector result = v;
    for (unsigned i = 0; i < n; ++i)
      result.local_element(i) *= to_velocity[i];
    return result;
  };

  Estimate estimate;
  std::vector<NodeVector> basis;
  std::vector<double> diagonal, off_diagonal;
  NodeVector next = start_;
  next.add(part_of_rough, rough_);
  for (unsigned i = 0; i < n; ++i)
    if (fixed[i / 3])
      next.local_element(i) = 0.;
  double length = next.l2_norm();
  while (true) {
    next *= 1. / length;
    basis.push_back(next);
    next = scaled(product(displacement, scaled(basis.back())));
    diagonal.push_back(next * basis.back());
    next.add(-diagonal.back(), basis.back());
    if (basis.size() > 1)
      next.add(-off_diagonal.back(), basis[basis.size() - 2]);
    length = next.l2_norm();
    if (!std::isfinite(length) || !std::isfinite(diagonal.back())) {
      estimate.upper_bound = std::numeric_limits<double>::infinity();
      start_ = rough_;
      return estimate;
    }

    const RitzPair top(diagonal, off_diagonal);
    ++estimate.n_products;
    estimate.ritz_value = top.value;
    estimate.upper_bound = top.value + length * std::abs(top.vector.back());
    const double residual = estimate.upper_bound - estimate.ritz_value;
    const bool patient = has_found_top_ || estimate.n_products >= least_products_at_first ||
                         length <= 1e-8 * top.value; // all that the start vector leads to
    if ((residual <= tolerance * estimate.ritz_value && patient) ||
        estimate.n_products == max_products) {
      has_found_top_ = true;
      start_ = 0.;
      for (unsigned k = 0; k < basis.size(); ++k)
        start_.add(top.vector[k], basis[k]);
      return estimate;
    }
    off_diagonal.push_back(length);
  }
}

} // namespace prosup::mechanics
