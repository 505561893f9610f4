#include "spectrum.h"

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "prosup/core/units.h"
#include "prosup/mechanics/explicit/central_differences.h"

namespace prosup::benchmarks {

using namespace dealii;
using mechanics::NodeVector;
using Matrix = LAPACKFullMatrix<double>;

namespace {

/// Residual internal - external force as a function of X and x.
class Residual {
public:
  explicit Residual(const HalfBall& breast) : breast_(breast), force_(breast.body) {
    force_.set_material(breast.material);
    for (unsigned node = 0; node < breast.body.n_owned_nodes(); ++node)
      if (!breast.fixed[node])
        for (unsigned c = 0; c < 3; ++c)
          free_.push_back(3 * node + c);
  }

  const std::vector<unsigned>& free() const { return free_; }
  mechanics::InternalForce& force() { return force_; }

  Vector<double> operator()(const NodeVector& X, const NodeVector& x) {
    force_.set_reference(X);
    NodeVector u, sum;
    breast_.body.initialize(u);
    breast_.body.initialize(sum);
    for (unsigned i = 0; i < u.locally_owned_size(); ++i)
      u.local_element(i) = x.local_element(i) - X.local_element(i);
    const std::vector<double> volume = force_.nodal_volume();
    for (unsigned i = 0; i < sum.locally_owned_size(); ++i)
      sum.local_element(i) = specific_weight * volume[i / 3] * breast_.gravity[i % 3];
    force_.subtract(u, sum);
    Vector<double> result(static_cast<unsigned>(free_.size()));
    for (unsigned i = 0; i < free_.size(); ++i)
      result[i] = -sum.local_element(free_[i]);
    return result;
  }

private:
  const HalfBall& breast_;
  mechanics::InternalForce force_;
  std::vector<unsigned> free_;
};

/// M^-1/2 dR/dz M^-1/2 where `moved` is X or x, times `sign`.
Matrix derivative(Residual& residual, NodeVector& moved, const NodeVector& X, const NodeVector& x,
                  const std::vector<double>& mass, double sign) {
  constexpr double step = 1e-4; // mm
  const std::vector<unsigned>& free = residual.free();
  Matrix result(static_cast<unsigned>(free.size()));
  for (unsigned j = 0; j < free.size(); ++j) {
    double& z = moved.local_element(free[j]);
    const double middle = z;
    z = middle + step;
    Vector<double> column = residual(X, x);
    z = middle - step;
    column -= residual(X, x);
    z = middle;
    for (unsigned i = 0; i < free.size(); ++i)
      result(i, j) =
          sign * column[i] / (2. * step) / std::sqrt(mass[free[i] / 3] * mass[free[j] / 3]);
  }
  return result;
}

double asymmetry(const Matrix& a) {
  double odd = 0., even = 0.;
  for (unsigned i = 0; i < a.m(); ++i)
    for (unsigned j = 0; j < a.m(); ++j) {
      odd += std::pow(a(i, j) - a(j, i), 2);
      even += std::pow(a(i, j) + a(j, i), 2);
    }
  return std::sqrt(odd / even);
}

std::vector<std::complex<double>> eigenvalues(Matrix a) {
  a.compute_eigenvalues();
  std::vector<std::complex<double>> result;
  for (unsigned i = 0; i < a.m(); ++i)
    result.push_back(a.eigenvalue(i));
  return result;
}

/// k^-1 a.
Matrix quotient(Matrix k, const Matrix& a) {
  k.compute_lu_factorization();
  Matrix result = a;
  k.solve(result);
  return result;
}

} // namespace

Spectrum measure_spectrum(const HalfBall& breast) {
  Residual residual(breast);
  NodeVector X = breast.unloaded, x = breast.body.vertex_positions();
  NodeVector u = x;
  u -= X;
  residual.force().set_reference(X);
  mechanics::HighestFrequency highest(breast.body, residual.force());
  const mechanics::Supports supports(breast.body, {1});
  const mechanics::StableMass mass =
      mechanics::stable_mass(supports, residual.force(), highest, u, tissue_density, 0.);
  const Matrix k = derivative(residual, x, X, x, mass.mass, 1.);
  const Matrix a = derivative(residual, X, X, x, mass.mass, -1.);

  Spectrum result;
  result.critical_step = mass.critical_step;
  result.asymmetry = asymmetry(a);
  double lowest = std::numeric_limits<double>::max(), highest_k = 0., highest_a = 0.;
  for (const auto& lambda : eigenvalues(k)) {
    lowest = std::min(lowest, lambda.real());
    highest_k = std::max(highest_k, lambda.real());
  }
  result.is_stable = lowest > 0.;
  if (!result.is_stable)
    return result;
  result.lowest_frequency = std::sqrt(lowest);
  for (const auto& lambda : eigenvalues(a)) {
    highest_a = std::max(highest_a, std::abs(lambda));
    result.largest_angle =
        std::max(result.largest_angle, std::abs(std::arg(lambda)) * 180. / numbers::PI);
    result.critical_damping =
        std::max(result.critical_damping, lambda.real() > 0.
                                              ? std::abs(lambda.imag()) / std::sqrt(lambda.real())
                                              : std::numeric_limits<double>::infinity());
  }
  result.step_ratio = std::sqrt(highest_k / highest_a);
  result.smallest_following = std::numeric_limits<double>::max();
  for (const auto& lambda : eigenvalues(quotient(k, a))) {
    result.step_ratio = std::sqrt(highest_k / highest_a);
    result.smallest_following = std::min(result.smallest_following, lambda.real());
    result.largest_jump = std::max(result.largest_jump, std::abs(1. - lambda));
  }
  return result;
}

} // namespace prosup::benchmarks
