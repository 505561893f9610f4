#include "dynamics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prosup::fdm {

using dealii::Tensor;

namespace {

// Skipping shorter gaps between nodes that move does not pay.
constexpr std::size_t shortest_gap = 16;

/// Largest sum of a row of |G G^T|, a bound of its largest eigenvalue.
double largest_inverse_stretch(const Tensor<2, 3>& G) {
  double largest = 0.;
  for (unsigned i = 0; i < 3; ++i) {
    double sum = 0.;
    for (unsigned j = 0; j < 3; ++j)
      sum += std::abs(G[i] * G[j]);
    largest = std::max(largest, sum);
  }
  return largest;
}

} // namespace

Dynamics::Dynamics(const Slab& slab, double density)
    : mu(slab.n_nodes(), Real(0)), lambda(slab.n_nodes(), Real(0)), slab_(slab),
      step_(kernel::best_kernels().step(Real())), density_(density), mobile_(slab.n_nodes(), false),
      mobility_(slab.n_nodes(), Real(0)) {
  for (unsigned c = 0; c < 3; ++c)
    displacement[c] = increment[c] = force[c] = mu;
}

void Dynamics::set_mobile(const std::vector<bool>& moves) {
  runs_.clear();
  for (std::size_t n = slab_.owned_begin(); n < slab_.owned_end(); ++n) {
    mobile_[n] = moves[n];
    if (!moves[n])
      continue;
    if (runs_.empty() || n >= runs_.back().second + shortest_gap)
      runs_.emplace_back(n, n);
    runs_.back().second = n + 1;
  }
}

void Dynamics::set_time_step(double time_step) {
  if (time_step_ > 0.)
    for (NodalField& component : increment)
      for (Real& value : component)
        value *= Real(time_step / time_step_);
  time_step_ = time_step;
}

void Dynamics::set_damping(double rate) {
  damping_ = rate;
  for (const auto& [begin, end] : runs_)
    for (std::size_t n = begin; n < end; ++n)
      mobility_[n] = mobile_[n] ? Real(1. / friction()) : Real(0);
}

double Dynamics::advance_increments() {
  kernel::Fields<Real> fields{};
  for (unsigned c = 0; c < 3; ++c) {
    fields.u[c] = displacement[c].data();
    fields.f[c] = force[c].data();
    fields.increment[c] = increment[c].data();
  }
  fields.mu = mu.data();
  fields.lambda = lambda.data();
  fields.mobility = mobility_.data();
  fields.row = std::ptrdiff_t(slab_.row());
  fields.plane = std::ptrdiff_t(slab_.plane());
  fields.spacing = Real(slab_.grid().spacing[0]);
  fields.inverse_density = Real(1. / density_);
  fields.squared_step = Real(time_step_ * time_step_);
  double min_jacobian = std::numeric_limits<double>::max();
  for (const auto& [begin, end] : runs_)
    min_jacobian = std::min(min_jacobian, double(step_(fields, begin, end)));
  return min_jacobian;
}

void Dynamics::move() {
  for (unsigned c = 0; c < 3; ++c) {
    Real* const u = displacement[c].data();
    const Real* const du = increment[c].data();
    for (const auto& [begin, end] : runs_)
      for (std::size_t n = begin; n < end; ++n)
        u[n] += du[n];
    slab_.exchange(displacement[c]);
  }
}

Tensor<1, 3> Dynamics::acceleration(const Vectors& before, std::size_t node) const {
  Tensor<1, 3> result;
  for (unsigned c = 0; c < 3; ++c)
    result[c] = (friction() * increment[c][node] - before[c][node]) / (time_step_ * time_step_);
  return result;
}

double Dynamics::critical_time_step() const {
  const double h = slab_.grid().spacing[0];
  const std::size_t stride[3] = {1, slab_.row(), slab_.plane()};
  double largest = 0.;
  for (const auto& [begin, end] : runs_)
    for (std::size_t n = begin; n < end; ++n) {
      if (!is_mobile(n))
        continue;
      Tensor<2, 3> F;
      for (unsigned k = 0; k < 3; ++k)
        for (unsigned I = 0; I < 3; ++I)
          F[k][I] = (k == I ? 1. : 0.) +
                    (displacement[k][n + stride[I]] - displacement[k][n - stride[I]]) / (2. * h);
      const double J = determinant(F);
      if (!(J > 0.)) // the next steps will tell
        continue;
      const double volumetric = mu[n] + lambda[n] * (1. - std::log(J));
      largest = std::max(largest, 3. * mu[n] + std::max(0., volumetric) *
                                                   largest_inverse_stretch(invert(F)));
    }
  return h * std::sqrt(density_ / largest);
}

} // namespace prosup::fdm
