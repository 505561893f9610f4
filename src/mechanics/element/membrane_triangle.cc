#include "membrane_triangle.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

using Vector = Tensor<1, 3>;
using Pair = std::array<Vector, 2>;
using Numbers = std::array<double, 2>;

Pair edges(const MembraneTriangle::Corners& corners) {
  return {corners[1] - corners[0], corners[2] - corners[0]};
}

PlaneMatrix metric(const Pair& d) {
  return {d[0] * d[0], d[0] * d[1], d[1] * d[1]};
}

/// sum_l m_kl d_l
Pair combined(const PlaneMatrix& m, const Pair& d) {
  return {m.a * d[0] + m.b * d[1], m.b * d[0] + m.c * d[1]};
}

Vector combined(const Numbers& v, const Pair& d) {
  return v[0] * d[0] + v[1] * d[1];
}

/// v_k U + w_k V
Pair crossed(const Numbers& v, const Numbers& w, const Pair& d) {
  const Vector V = combined(v, d), U = combined(w, d);
  return {v[0] * U + w[0] * V, v[1] * U + w[1] * V};
}

/// sum_l d_l w_l^T
Tensor<2, 3> sum_of_products(const Pair& d, const Pair& w) {
  return outer_product(d[0], w[0]) + outer_product(d[1], w[1]);
}

/// The longer column of M^-1 m M^-1 - b M^-1 = (a - b) v v^T, made a vector of length 1 in M.
Numbers eigenvector(const PlaneMatrix& M, const PlaneMatrix& M_inverse, const PlaneMatrix& m,
                    double b) {
  const PlaneMatrix& q = M_inverse;
  const Numbers first{m.a * q.a + m.b * q.b, m.b * q.a + m.c * q.b},
      second{m.a * q.b + m.b * q.c, m.b * q.b + m.c * q.c}; // columns of m M^-1
  Numbers v{q.a * first[0] + q.b * first[1] - b * q.a, q.b * first[0] + q.c * first[1] - b * q.b};
  const Numbers other{q.a * second[0] + q.b * second[1] - b * q.b,
                      q.b * second[0] + q.c * second[1] - b * q.c};
  if (std::abs(other[1]) > std::abs(v[0])) // the diagonal is not negative
    v = other;
  const double square = M.a * v[0] * v[0] + 2. * M.b * v[0] * v[1] + M.c * v[1] * v[1];
  return {v[0] / std::sqrt(square), v[1] / std::sqrt(square)};
}

/// The vector of length 1 in M that is perpendicular to v in M.
Numbers perpendicular(const PlaneMatrix& M, const Numbers& v) {
  const double scale = 1. / std::sqrt(M.determinant());
  return {-scale * (M.b * v[0] + M.c * v[1]), scale * (M.a * v[0] + M.b * v[1])};
}

/// Blocks of the three corners from those of the two edges, block(k, n).
template <typename Block>
MembraneTriangle::Blocks at_corners(const Block& block) {
  MembraneTriangle::Blocks result;
  for (unsigned k = 0; k < 2; ++k)
    for (unsigned n = 0; n < 2; ++n) {
      const Tensor<2, 3> value = block(k, n);
      result[3 * (k + 1) + n + 1] += value;
      result[n + 1] -= value;
      result[3 * (k + 1)] -= value;
      result[0] += value;
    }
  return result;
}

} // namespace

MembraneTriangle::MembraneTriangle(const Corners& X, const Corners& x, double stiffness)
    : D_(edges(X)), d_(edges(x)), M_inverse_(metric(D_).inverse()),
      m_inverse_(metric(d_).inverse()),
      area_stiffness_(0.5 * std::sqrt(metric(D_).determinant()) * stiffness),
      stretch_(M_inverse_, metric(D_).determinant(), metric(d_)) {
  if (stretch_.is_taut() || !stretch_.is_stretched())
    return;
  v_ = eigenvector(metric(D_), M_inverse_, metric(d_), stretch_.second);
  w_ = perpendicular(metric(D_), v_);
}

PlaneMatrix MembraneTriangle::stress() const {
  const auto [a, b] = stretch_;
  if (stretch_.is_taut()) {
    const double c = area_stiffness_ / (a * b);
    return {area_stiffness_ * M_inverse_.a - c * m_inverse_.a,
            area_stiffness_ * M_inverse_.b - c * m_inverse_.b,
            area_stiffness_ * M_inverse_.c - c * m_inverse_.c};
  }
  if (is_slack())
    return {0., 0., 0.};
  const double factor = area_stiffness_ * (1. - std::pow(a, -1.5));
  return {factor * v_[0] * v_[0], factor * v_[0] * v_[1], factor * v_[1] * v_[1]};
}

MembraneTriangle::Corners MembraneTriangle::forces() const {
  const Pair f = combined(stress(), d_);
  return {-f[0] - f[1], f[0], f[1]};
}

MembraneTriangle::Blocks MembraneTriangle::by_loaded() const {
  if (is_slack())
    return {};
  const auto [a, b] = stretch_;
  const Tensor<2, 3> identity = unit_symmetric_tensor<3>();
  const PlaneMatrix T = stress();
  if (stretch_.is_taut()) {
    const double c = area_stiffness_ / (a * b);
    const Pair p = combined(m_inverse_, d_);
    const Tensor<2, 3> P = sum_of_products(d_, p);
    return at_corners([&](unsigned k, unsigned n) {
      return T(k, n) * identity + c * (2. * outer_product(p[k], p[n]) + outer_product(p[n], p[k]) +
                                       m_inverse_(k, n) * P);
    });
  }
  const Vector V = combined(v_, d_);
  const Pair B = crossed(v_, w_, d_);
  const double along = 3. * std::pow(a, -2.5), turned = (1. - std::pow(a, -1.5)) / (a - b);
  return at_corners([&](unsigned k, unsigned n) {
    return T(k, n) * identity + area_stiffness_ * (along * v_[k] * v_[n] * outer_product(V, V) +
                                                   turned * outer_product(B[k], B[n]));
  });
}

MembraneTriangle::Blocks MembraneTriangle::by_unloaded() const {
  if (is_slack())
    return {};
  const auto [a, b] = stretch_;
  const Pair P0 = combined(M_inverse_, D_), f = combined(stress(), d_);
  if (stretch_.is_taut()) {
    const double c = area_stiffness_ / (a * b);
    const Pair p = combined(m_inverse_, d_), h = combined(M_inverse_, d_);
    const Tensor<2, 3> F = sum_of_products(d_, P0);
    return at_corners([&](unsigned k, unsigned n) {
      return outer_product(f[k] - 2. * c * p[k], P0[n]) -
             area_stiffness_ * (M_inverse_(k, n) * F + outer_product(h[n], P0[k]));
    });
  }
  const Vector V = combined(v_, d_), V0 = combined(v_, D_);
  const Pair B = crossed(v_, w_, d_), B0 = crossed(v_, w_, D_);
  const double decay = std::pow(a, -1.5), turned = (1. - decay) * a / (a - b);
  return at_corners([&](unsigned k, unsigned n) {
    return outer_product(f[k], P0[n]) -
           area_stiffness_ * ((2. + decay) * v_[k] * v_[n] * outer_product(V, V0) +
                              turned * outer_product(B[k], B0[n]));
  });
}

} // namespace prosup::mechanics
