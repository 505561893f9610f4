#ifndef PROSUP_MECHANICS_ELEMENT_KERNEL_H
#define PROSUP_MECHANICS_ELEMENT_KERNEL_H

#include <cstddef>
#include <cstdint>

// The hot loops. This header and what it declares see neither deal.II nor the
// standard library's templates: the kernels are compiled with -ffast-math and
// once for each instruction set, and neither may leak into inline functions
// shared with other files.

namespace prosup::mechanics::kernel {

constexpr int n_lanes = 8;

/// Nodal vectors have four doubles a node, aligned to 32 bytes: three
/// components and one of padding (or the nodal pressure, see below), so that
/// lanes are gathered by whole loads and a transposition.
constexpr int node_stride = 4;

/// What the internal force has to know of the reference configuration at one
/// quadrature point of eight elements. With D = dX/dxi, E = dx/dxi (columns are
/// the derivatives by the reference coordinates), w the quadrature weight and
/// J = det E / det D, the neo-Hookean P = mu F + (lambda ln J - mu) F^-T gives
///   w det D P D^-T = mu E [w det D D^-1 D^-T] + w (lambda ln J - mu)/J cof E,
/// so that six numbers of the symmetric `metric` and one of `inverse_det`
/// replace D^-1, the volume and F. A force f_a is this times dN_a/dxi.
template <typename Real>
struct alignas(64) ReferencePoint {
  Real metric[6][n_lanes];   ///< w det D D^-1 D^-T: 11, 12, 13, 22, 23, 33; mm
  Real inverse_det[n_lanes]; ///< 1/det D, 1/mm^3
};

/// Eight elements side by side. Lanes without an element hold a unit element on
/// nodes of its own behind those of the body.
template <typename Real, int n_points, int n_nodes>
struct alignas(64) Batch {
  ReferencePoint<Real> point[n_points];
  std::uint32_t node[n_nodes][n_lanes];
};
template <typename Real>
using LinearBatch = Batch<Real, 1, 4>;
template <typename Real>
using QuadraticBatch = Batch<Real, 4, 10>;

/// Lame parameters of eight elements, Pa. A body of one material has a single
/// one of these and a stride of 0.
template <typename Real>
struct alignas(64) BatchMaterial {
  Real mu[n_lanes];
  Real lambda[n_lanes];
};

template <typename Real>
struct Materials {
  const BatchMaterial<Real>* data;
  std::size_t stride; ///< 0 or 1
};

/// The kernels of one instruction set. Ranges are batches [begin, end).
template <typename Real>
struct Kernels {
  const char* instruction_set;

  /// Fills the reference points from reference positions. Returns the
  /// smallest det D.
  double (*set_linear_reference)(LinearBatch<Real>* batches, std::size_t begin, std::size_t end,
                                 const double* reference);
  double (*set_quadratic_reference)(QuadraticBatch<Real>* batches, std::size_t begin,
                                    std::size_t end, const double* reference);

  /// Adds internal forces to `force`; returns the smallest J. Where J <= 0 the
  /// force is computed at a tiny positive J: the caller has to look at what is
  /// returned.
  double (*add_linear)(const LinearBatch<Real>* batches, std::size_t begin, std::size_t end,
                       Materials<Real> materials, const double* positions, double* force);
  double (*add_quadratic)(const QuadraticBatch<Real>* batches, std::size_t begin, std::size_t end,
                          Materials<Real> materials, const double* positions, double* force);

  /// Averaged nodal pressure, first pass: adds a quarter of each element's
  /// volume det E/6 to its nodes (one double a node).
  void (*add_nodal_volumes)(const LinearBatch<Real>* batches, std::size_t begin, std::size_t end,
                            const double* positions, double* volumes);
  /// Second pass: as add_linear, with the mean of the nodal pressures, which
  /// stand in the fourth place of `positions`, instead of lambda ln J / J.
  double (*add_nodal_pressure)(const LinearBatch<Real>* batches, std::size_t begin, std::size_t end,
                               Materials<Real> materials, const double* positions, double* force);
};

/// All kernels that this processor can run, the plainest first; `n` of them.
template <typename Real>
const Kernels<Real>* const* all_kernels(int& n);

// One translation unit each.
namespace baseline {
extern const Kernels<double> double_kernels;
extern const Kernels<float> float_kernels;
} // namespace baseline
namespace avx2 {
extern const Kernels<double> double_kernels;
extern const Kernels<float> float_kernels;
} // namespace avx2
namespace avx512 {
extern const Kernels<double> double_kernels;
extern const Kernels<float> float_kernels;
} // namespace avx512

} // namespace prosup::mechanics::kernel

#endif
