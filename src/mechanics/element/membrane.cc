#include "membrane.h"

#include <algorithm>
#include <cmath>

#include "element_kernel.h"

namespace prosup::mechanics {

using namespace dealii;
using kernel::node_stride;

namespace {

/// T of MembraneTriangle for the metric m.
PlaneMatrix stress(const PlaneMatrix& M_inverse, double det_M, const PlaneMatrix& m) {
  const MembraneStretch stretch(M_inverse, det_M, m);
  const double determinant = m.determinant();
  if (stretch.is_taut()) { // m^-1 = adj(m)/det m
    const double r = det_M / (determinant * determinant);
    return {M_inverse.a - r * m.c, M_inverse.b + r * m.b, M_inverse.c - r * m.a};
  }
  if (!stretch.is_stretched())
    return {0., 0., 0.};
  // (a - b) v v^T = M^-1 m M^-1 - b M^-1
  const double a = stretch.first, b = stretch.second;
  const double factor = (1. - 1. / (a * std::sqrt(a))) / (a - b);
  const PlaneMatrix& q = M_inverse;
  const double k00 = q.a * m.a + q.b * m.b, k01 = q.a * m.b + q.b * m.c,
               k10 = q.b * m.a + q.c * m.b, k11 = q.b * m.b + q.c * m.c; // M^-1 m
  return {factor * (k00 * q.a + k01 * q.b - b * q.a), factor * (k00 * q.b + k01 * q.c - b * q.b),
          factor * (k10 * q.b + k11 * q.c - b * q.c)};
}

// The edges of a quadratic face's corners 0 1 2 are its nodes 3 (0-1), 4 (1-2) and 5 (2-0).
constexpr unsigned parts[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};

} // namespace

std::vector<std::array<unsigned, 3>> membrane_triangles(const Body& body, const Skin& skin) {
  std::vector<std::array<unsigned, 3>> triangles;
  if (!(skin.stiffness > 0.))
    return triangles;
  for (const BoundaryFace& face : body.boundary_faces()) {
    if (face.id != skin.boundary)
      continue;
    const auto& n = face.nodes;
    if (n.size() == 3)
      triangles.push_back({n[0], n[1], n[2]});
    else
      for (const auto& part : parts)
        triangles.push_back({n[part[0]], n[part[1]], n[part[2]]});
  }
  return triangles;
}

MembraneTriangle::Corners corners_of(const std::array<unsigned, 3>& triangle,
                                     const NodeVector& positions) {
  return {node_value(positions, triangle[0]), node_value(positions, triangle[1]),
          node_value(positions, triangle[2])};
}

Membrane::Membrane(const Body& body, const Skin& skin)
    : stiffness_(skin.stiffness), triangles_(membrane_triangles(body, skin)) {}

void Membrane::set_reference(const NodeVector& unloaded) {
  references_.clear();
  for (const auto& triangle : triangles_) {
    const auto X = corners_of(triangle, unloaded);
    const Tensor<1, 3> D1 = X[1] - X[0], D2 = X[2] - X[0];
    const PlaneMatrix M{D1 * D1, D1 * D2, D2 * D2};
    references_.push_back(
        {M.inverse(), M.determinant(), 0.5 * std::sqrt(M.determinant()) * stiffness_});
  }
}

void Membrane::add_forces(const double* positions, double* force) const {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const auto& nodes = triangles_[t];
    const Reference& reference = references_[t];
    const double* x[3];
    double* f[3];
    for (unsigned a = 0; a < 3; ++a) {
      x[a] = positions + node_stride * std::size_t(nodes[a]);
      f[a] = force + node_stride * std::size_t(nodes[a]);
    }
    double d[2][3];
    for (unsigned k = 0; k < 2; ++k)
      for (unsigned c = 0; c < 3; ++c)
        d[k][c] = x[k + 1][c] - x[0][c];
    const auto product = [&](unsigned k, unsigned l) {
      return d[k][0] * d[l][0] + d[k][1] * d[l][1] + d[k][2] * d[l][2];
    };
    const PlaneMatrix T = stress(reference.inverse_metric, reference.determinant,
                                 {product(0, 0), product(0, 1), product(1, 1)});
    for (unsigned c = 0; c < 3; ++c) {
      const double f1 = reference.area_stiffness * (T.a * d[0][c] + T.b * d[1][c]),
                   f2 = reference.area_stiffness * (T.b * d[0][c] + T.c * d[1][c]);
      f[0][c] -= f1 + f2;
      f[1][c] += f1;
      f[2][c] += f2;
    }
  }
}

void Membrane::add_stiffness_bound(const NodeVector& unloaded, const NodeVector& displacement,
                                   std::vector<double>& bound) const {
  for (const auto& triangle : triangles_) {
    const auto X = corners_of(triangle, unloaded);
    auto x = corners_of(triangle, displacement);
    for (unsigned a = 0; a < 3; ++a)
      x[a] += X[a];
    const auto blocks = MembraneTriangle(X, x, stiffness_).by_loaded();
    for (unsigned a = 0; a < 3; ++a)
      for (unsigned b = 0; b < 3; ++b)
        bound[triangle[a]] += blocks[3 * a + b].norm();
  }
}

} // namespace prosup::mechanics
