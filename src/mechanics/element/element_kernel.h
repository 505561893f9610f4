#ifndef PROSUP_MECHANICS_ELEMENT_KERNEL_H
#define PROSUP_MECHANICS_ELEMENT_KERNEL_H

#include <cstddef>
#include <cstdint>

#include "prosup/mechanics/laws/law_list.h"

// The hot loops. This header and what it includes use neither deal.II nor the
// standard library's templates: the kernels are compiled with -ffast-math and
// once for each instruction set, and neither may leak into inline functions
// shared with other files.

namespace prosup::mechanics::kernel {

constexpr int n_lanes = 8;

/// Nodal vectors have four doubles per node, aligned to 32 bytes: three
/// components and one of padding (or the nodal pressure, see below), so that
/// lanes are gathered by whole loads and a transposition.
constexpr int node_stride = 4;

/// The reference configuration at one quadrature point of eight elements, as far as the internal
/// force depends on it. With D = dX/dxi, E = dx/dxi (columns are derivatives with respect to the
/// reference coordinates), the quadrature weight w and J = det E / det D, a stress
/// P = a F + b F^-T (see coefficients.h) gives
///   w det D P D^-T = a E [w det D D^-1 D^-T] + w b/J cof E,
///   I1 = tr(E D^-1 D^-T E^T).
/// The six numbers of the symmetric `metric` and `inverse_det` thus replace D^-1, the volume and
/// F. The force on node a is this matrix times dN_a/dxi.
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

/// Lame parameters of eight elements, Pa. A uniform body has a single one of these,
/// with a stride of 0.
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

/// The kernels of one instruction set that compute forces of a law. They work on the batches
/// [begin, end), add internal forces to `force` and return the smallest J. Where J <= 0 they
/// compute the force at a small positive J: the caller has to check what is returned.
template <typename Real, typename Law>
struct ForceKernels {
  double (*add_linear)(const Law& law, const LinearBatch<Real>* batches, std::size_t begin,
                       std::size_t end, Materials<Real> materials, const double* positions,
                       double* force);
  double (*add_quadratic)(const Law& law, const QuadraticBatch<Real>* batches, std::size_t begin,
                          std::size_t end, Materials<Real> materials, const double* positions,
                          double* force);
  /// Second pass of averaged nodal pressure: as add_linear, with the mean of the nodal pressures,
  /// which stand in the fourth place of `positions`, in place of the volumetric part of the law.
  double (*add_nodal_pressure)(const Law& law, const LinearBatch<Real>* batches, std::size_t begin,
                               std::size_t end, Materials<Real> materials, const double* positions,
                               double* force);
};

template <typename Real, typename List>
struct KernelsOfLaws;
template <typename Real, typename... Law>
struct KernelsOfLaws<Real, LawList<Law...>> : ForceKernels<Real, Law>... {};

/// The kernels of one instruction set: those of each law, and those that depend on none.
template <typename Real>
struct Kernels : KernelsOfLaws<Real, Laws> {
  const char* instruction_set;

  /// Fills the reference points from reference positions. Returns the smallest det D.
  double (*set_linear_reference)(LinearBatch<Real>* batches, std::size_t begin, std::size_t end,
                                 const double* reference);
  double (*set_quadratic_reference)(QuadraticBatch<Real>* batches, std::size_t begin,
                                    std::size_t end, const double* reference);

  /// First pass of averaged nodal pressure: adds a quarter of the volume det E/6 of each element
  /// to its nodes (one double per node).
  void (*add_nodal_volumes)(const LinearBatch<Real>* batches, std::size_t begin, std::size_t end,
                            const double* positions, double* volumes);

  template <typename Law>
  const ForceKernels<Real, Law>& of(const Law&) const {
    return *this;
  }
};

/// The kernels of all instruction sets of this processor, the simplest first; `n` of them.
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
