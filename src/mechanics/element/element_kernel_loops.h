// The kernels, included once per instruction set by element_kernel_<set>.cc,
// which names the namespace and the group of double lanes that fills a
// register. No include guard: each file includes it once.

#include "element_kernel.h"

namespace prosup::mechanics::kernel {
namespace PROSUP_INSTRUCTION_SET {
namespace {

#include "kernel_lanes.h"

constexpr double smallest_jacobian = 1e-3, beyond_all = 1e30;

// Columns are derivatives with respect to the reference coordinates.
template <typename Value>
using Matrix = Value[3][3];

template <typename Value>
PROSUP_INLINE void cofactors(const Matrix<Value>& A, Matrix<Value>& cof, Value& det) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      cof[i][j] = A[i1][j1] * A[i2][j2] - A[i1][j2] * A[i2][j1];
    }
  det = A[0][0] * cof[0][0] + A[0][1] * cof[0][1] + A[0][2] * cof[0][2];
}

template <typename Group>
PROSUP_INLINE typename Group::Value
fill_reference_point(const Matrix<typename Group::Value>& D, double weight,
                     ReferencePoint<typename Group::Real>& point, int lane) {
  using Value = typename Group::Value;
  Matrix<Value> cof;
  Value det;
  cofactors(D, cof, det);
  // w det D^-1 D^-T = w/det cof^T cof
  const Value factor = all<Group>(weight) / det;
  int k = 0;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b, ++k)
      store<Group>(point.metric[k] + lane, factor * (cof[0][a] * cof[0][b] + cof[1][a] * cof[1][b] +
                                                     cof[2][a] * cof[2][b]));
  store<Group>(point.inverse_det + lane, all<Group>(1.) / det);
  return det;
}

template <typename Value>
PROSUP_INLINE Value smaller(Value a, Value b) {
  return a < b ? a : b;
}
template <typename Value>
PROSUP_INLINE Value larger(Value a, Value b) {
  return a > b ? a : b;
}

/// I1 = tr(F^T F) = E^T E : D^-1 D^-T.
template <typename Group>
PROSUP_INLINE typename Group::Value
first_invariant(const Matrix<typename Group::Value>& E,
                const ReferencePoint<typename Group::Real>& point, double weight, int lane) {
  using Value = typename Group::Value;
  Value sum{};
  int k = 0;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b, ++k) {
      const Value product = E[0][a] * E[0][b] + E[1][a] * E[1][b] + E[2][a] * E[2][b];
      sum += (a == b ? product : product + product) * load<Group>(point.metric[k] + lane);
    }
  return sum * load<Group>(point.inverse_det + lane) * typename Group::Real(1. / weight);
}

/// S = a E metric + w b/J cof E: the contribution of the point to nodal forces, f_a = S dN_a/dxi.
/// a and the part of b from the distortion are those of the law; `b_over_J(b, J, ln J)` adds the
/// volumetric part and divides by J. What a law does not use (I1, ln J) is not computed.
template <typename Group, typename Law, typename Volumetric>
PROSUP_INLINE typename Group::Value
point_stress(const Law& law, const Matrix<typename Group::Value>& E,
             const ReferencePoint<typename Group::Real>& point, typename Group::Value mu,
             double weight, int lane, Volumetric b_over_J, Matrix<typename Group::Value>& S) {
  using Value = typename Group::Value;
  Matrix<Value> cof;
  Value det;
  cofactors(E, cof, det);
  const Value J = det * load<Group>(point.inverse_det + lane);
  const Value safe = larger(J, all<Group>(smallest_jacobian));
  const Value log_J = logarithm<Group>(safe);
  const StressCoefficients<Value> stress =
      law.distortion_stress(mu, first_invariant<Group>(E, point, weight, lane), log_J);
  const Value q = typename Group::Real(weight) * b_over_J(stress.b, safe, log_J);
  Value metric[6];
  for (int k = 0; k < 6; ++k)
    metric[k] = stress.a * load<Group>(point.metric[k] + lane);
  for (int c = 0; c < 3; ++c) {
    S[c][0] = q * cof[c][0] + E[c][0] * metric[0] + E[c][1] * metric[1] + E[c][2] * metric[2];
    S[c][1] = q * cof[c][1] + E[c][0] * metric[1] + E[c][1] * metric[3] + E[c][2] * metric[4];
    S[c][2] = q * cof[c][2] + E[c][0] * metric[2] + E[c][1] * metric[4] + E[c][2] * metric[5];
  }
  return J;
}

/// As point_stress(), with the volumetric part of the law.
template <typename Group, typename Law>
PROSUP_INLINE typename Group::Value
point_stress(const Law& law, const Matrix<typename Group::Value>& E,
             const ReferencePoint<typename Group::Real>& point, typename Group::Value mu,
             typename Group::Value lambda, double weight, int lane,
             Matrix<typename Group::Value>& S) {
  using Value = typename Group::Value;
  return point_stress<Group>(
      law, E, point, mu, weight, lane,
      [&](Value b, Value J, Value log_J) { return (law.volume_slope(lambda, log_J) + b) / J; }, S);
}

template <typename Group>
PROSUP_INLINE void linear_derivative(const std::uint32_t (&node)[4][n_lanes], int lane,
                                     const double* field, Matrix<typename Group::Value>& E) {
  for (int b = 0; b < 3; ++b) {
    typename Group::Value edge[4];
    Group::gather(field, node[b + 1] + lane, node[0] + lane, edge);
    for (int c = 0; c < 3; ++c)
      E[c][b] = edge[c];
  }
}

template <typename Group>
PROSUP_INLINE void scatter_linear(const std::uint32_t (&node)[4][n_lanes], int lane,
                                  const Matrix<typename Group::Value>& S, double* force) {
  typename Group::Value first[3];
  for (int c = 0; c < 3; ++c)
    first[c] = -(S[c][0] + S[c][1] + S[c][2]);
  Group::scatter(force, node[0] + lane, first[0], first[1], first[2]);
  for (int b = 0; b < 3; ++b)
    Group::scatter(force, node[b + 1] + lane, S[0][b], S[1][b], S[2][b]);
}

constexpr double linear_weight = 1. / 6., quadratic_weight = 1. / 24.;

template <typename Group>
double set_linear_reference(LinearBatch<typename Group::Real>* batches, std::size_t begin,
                            std::size_t end, const double* reference) {
  typename Group::Value smallest = all<Group>(beyond_all);
  for (std::size_t i = begin; i < end; ++i)
    for (int lane = 0; lane < n_lanes; lane += Group::width) {
      Matrix<typename Group::Value> D;
      linear_derivative<Group>(batches[i].node, lane, reference, D);
      smallest = smaller(smallest,
                         fill_reference_point<Group>(D, linear_weight, batches[i].point[0], lane));
    }
  return smallest_lane<Group>(smallest);
}

template <typename Group, typename Law>
double add_linear(const Law& law, const LinearBatch<typename Group::Real>* batches,
                  std::size_t begin, std::size_t end, Materials<typename Group::Real> materials,
                  const double* positions, double* force) {
  using Value = typename Group::Value;
  Value smallest = all<Group>(beyond_all);
  for (std::size_t i = begin; i < end; ++i)
    for (int lane = 0; lane < n_lanes; lane += Group::width) {
      const auto& material = materials.data[i * materials.stride];
      Matrix<Value> E, S;
      linear_derivative<Group>(batches[i].node, lane, positions, E);
      const Value J =
          point_stress<Group>(law, E, batches[i].point[0], load<Group>(material.mu + lane),
                              load<Group>(material.lambda + lane), linear_weight, lane, S);
      smallest = smaller(smallest, J);
      scatter_linear<Group>(batches[i].node, lane, S, force);
    }
  return smallest_lane<Group>(smallest);
}

template <typename Group>
void add_nodal_volumes(const LinearBatch<typename Group::Real>* batches, std::size_t begin,
                       std::size_t end, const double* positions, double* volumes) {
  using Value = typename Group::Value;
  for (std::size_t i = begin; i < end; ++i)
    for (int lane = 0; lane < n_lanes; lane += Group::width) {
      Matrix<Value> E;
      linear_derivative<Group>(batches[i].node, lane, positions, E);
      const Value det = E[0][0] * (E[1][1] * E[2][2] - E[1][2] * E[2][1]) +
                        E[0][1] * (E[1][2] * E[2][0] - E[1][0] * E[2][2]) +
                        E[0][2] * (E[1][0] * E[2][1] - E[1][1] * E[2][0]);
      const Value quarter = det * typename Group::Real(1. / 24.);
      for (int l = 0; l < Group::width; ++l)
        for (int a = 0; a < 4; ++a)
          volumes[batches[i].node[a][lane + l]] += quarter[l];
    }
}

template <typename Group, typename Law>
double add_nodal_pressure(const Law& law, const LinearBatch<typename Group::Real>* batches,
                          std::size_t begin, std::size_t end,
                          Materials<typename Group::Real> materials, const double* positions,
                          double* force) {
  using Value = typename Group::Value;
  using Real = typename Group::Real;
  Value smallest = all<Group>(beyond_all);
  for (std::size_t i = begin; i < end; ++i)
    for (int lane = 0; lane < n_lanes; lane += Group::width) {
      const auto& node = batches[i].node;
      Matrix<Value> E, S;
      Value pressure;
      for (int l = 0; l < Group::width; ++l)
        pressure[l] = static_cast<Real>(node_at(positions, node[0][lane + l])[3]);
      for (int b = 0; b < 3; ++b) {
        Value edge[4];
        Group::gather(positions, node[b + 1] + lane, node[0] + lane, edge);
        for (int c = 0; c < 3; ++c)
          E[c][b] = edge[c];
        pressure += Real(0.25) * edge[3];
      }
      const Value J = point_stress<Group>(
          law, E, batches[i].point[0], load<Group>(materials.data[i * materials.stride].mu + lane),
          linear_weight, lane, [&](Value b, Value J, Value) { return pressure + b / J; }, S);
      smallest = smaller(smallest, J);
      scatter_linear<Group>(node, lane, S, force);
    }
  return smallest_lane<Group>(smallest);
}

// Quadratic elements. The derivatives with respect to the barycentric coordinates L_m
// are linear in L; at corner k they are 4 x_km - x_m, and 3 x_k for m = k, where
// x_km is the node of the edge between k and m. A quadrature point has one
// barycentric coordinate alpha and three beta.
constexpr double alpha = 0.5854101966249685, beta = 0.1381966011250105;
constexpr int edge_node[4][4] = {{0, 4, 6, 7}, {4, 1, 5, 8}, {6, 5, 2, 9}, {7, 8, 9, 3}};

/// dx/dL_m at all points, for one component of the nodes' positions.
template <typename Group>
PROSUP_INLINE void barycentric_derivatives(const typename Group::Value (&x)[10],
                                           typename Group::Value (&at)[4][4]) {
  using Value = typename Group::Value;
  using Real = typename Group::Real;
  for (int m = 0; m < 4; ++m) {
    Value sum{};
    for (int k = 0; k < 4; ++k)
      if (k != m)
        sum += x[edge_node[k][m]];
    const Value mean = sum * Real(4. * beta); // of the four corners, times 4 beta
    for (int q = 0; q < 4; ++q) {
      const Value corner = q == m ? Real(3) * x[m] : Real(4) * x[edge_node[q][m]] - x[m];
      at[q][m] = mean + Real(alpha - beta) * corner;
    }
  }
}

template <typename Group>
PROSUP_INLINE void gather_quadratic(const std::uint32_t (&node)[10][n_lanes], int lane,
                                    const double* field,
                                    typename Group::Value (&derivative)[4][3][3]) {
  using Value = typename Group::Value;
  // Relative to the first node: exact for derivatives, and small for floats.
  Value x[3][10];
  for (int a = 0; a < 10; ++a) {
    Value v[4] = {};
    if (a > 0)
      Group::gather(field, node[a] + lane, node[0] + lane, v);
    for (int c = 0; c < 3; ++c)
      x[c][a] = v[c];
  }
  for (int c = 0; c < 3; ++c) {
    Value at[4][4];
    barycentric_derivatives<Group>(x[c], at);
    for (int q = 0; q < 4; ++q)
      for (int b = 0; b < 3; ++b)
        derivative[q][c][b] = at[q][b + 1] - at[q][0];
  }
}

/// The transpose of gather_quadratic: forces from all points to the nodes.
template <typename Group>
PROSUP_INLINE void scatter_quadratic(const std::uint32_t (&node)[10][n_lanes], int lane,
                                     const typename Group::Value (&S)[4][3][3], double* force) {
  using Value = typename Group::Value;
  using Real = typename Group::Real;
  Value f[10][3];
  for (int c = 0; c < 3; ++c) {
    Value corner[4][4]; // force by the derivative at corner k by L_m
    Value total[4];
    for (int m = 0; m < 4; ++m) {
      Value by_point[4];
      for (int q = 0; q < 4; ++q)
        by_point[q] = m == 0 ? -(S[q][c][0] + S[q][c][1] + S[q][c][2]) : S[q][c][m - 1];
      total[m] = by_point[0] + by_point[1] + by_point[2] + by_point[3];
      for (int k = 0; k < 4; ++k)
        corner[k][m] = Real(beta) * total[m] + Real(alpha - beta) * by_point[k];
    }
    for (int m = 0; m < 4; ++m) {
      f[m][c] = Real(4) * corner[m][m] - total[m];
      for (int k = 0; k < m; ++k)
        f[edge_node[k][m]][c] = Real(4) * (corner[k][m] + corner[m][k]);
    }
  }
  for (int a = 0; a < 10; ++a)
    Group::scatter(force, node[a] + lane, f[a][0], f[a][1], f[a][2]);
}

template <typename Group>
double set_quadratic_reference(QuadraticBatch<typename Group::Real>* batches, std::size_t begin,
                               std::size_t end, const double* reference) {
  using Value = typename Group::Value;
  Value smallest = all<Group>(beyond_all);
  for (std::size_t i = begin; i < end; ++i)
    for (int lane = 0; lane < n_lanes; lane += Group::width) {
      Value D[4][3][3];
      gather_quadratic<Group>(batches[i].node, lane, reference, D);
      for (int q = 0; q < 4; ++q)
        smallest = smaller(smallest, fill_reference_point<Group>(D[q], quadratic_weight,
                                                                 batches[i].point[q], lane));
    }
  return smallest_lane<Group>(smallest);
}

template <typename Group, typename Law>
double add_quadratic(const Law& law, const QuadraticBatch<typename Group::Real>* batches,
                     std::size_t begin, std::size_t end, Materials<typename Group::Real> materials,
                     const double* positions, double* force) {
  using Value = typename Group::Value;
  Value smallest = all<Group>(beyond_all);
  for (std::size_t i = begin; i < end; ++i)
    for (int lane = 0; lane < n_lanes; lane += Group::width) {
      const auto& material = materials.data[i * materials.stride];
      const Value mu = load<Group>(material.mu + lane),
                  lambda = load<Group>(material.lambda + lane);
      Value E[4][3][3], S[4][3][3];
      gather_quadratic<Group>(batches[i].node, lane, positions, E);
      for (int q = 0; q < 4; ++q)
        smallest = smaller(smallest, point_stress<Group>(law, E[q], batches[i].point[q], mu, lambda,
                                                         quadratic_weight, lane, S[q]));
      scatter_quadratic<Group>(batches[i].node, lane, S, force);
    }
  return smallest_lane<Group>(smallest);
}

template <typename Group, typename... Law>
constexpr Kernels<typename Group::Real> kernels_of(LawList<Law...>) {
  using Real = typename Group::Real;
  return {{ForceKernels<Real, Law>{add_linear<Group, Law>, add_quadratic<Group, Law>,
                                   add_nodal_pressure<Group, Law>}...},
          PROSUP_INSTRUCTION_SET_NAME,
          set_linear_reference<Group>,
          set_quadratic_reference<Group>,
          add_nodal_volumes<Group>};
}

} // namespace

// Constants, so that no instruction of the set runs before the processor is asked for it.
constexpr Kernels<double> double_kernels = kernels_of<PROSUP_DOUBLES>(Laws());
constexpr Kernels<float> float_kernels = kernels_of<EightFloats>(Laws());

} // namespace PROSUP_INSTRUCTION_SET
} // namespace prosup::mechanics::kernel
