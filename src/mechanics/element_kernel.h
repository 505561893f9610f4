#ifndef PROSUP_MECHANICS_ELEMENT_KERNEL_H
#define PROSUP_MECHANICS_ELEMENT_KERNEL_H

#include <cstddef>
#include <cstdint>

// The hot loop. This header and its source see neither deal.II nor the
// standard library's templates: the source is compiled with -ffast-math, which
// must not leak into inline functions shared with other files.

namespace prosup::mechanics::kernel {

constexpr int n_lanes = 8;

/// Eight tetrahedra side by side (structure of arrays). With the edge vectors
/// of the reference configuration as columns of D = [X1-X0, X2-X0, X3-X0], the
/// displacement gradient is H = [u1-u0, u2-u0, u3-u0] D^-1.
struct alignas(64) Batch {
  double inverse_edges[3][3][n_lanes]; ///< D^-1, 1/mm; row b is the gradient of N_(b+1)
  double volume[n_lanes];              ///< of the reference configuration, mm^3; 0 for padding
  double mu[n_lanes];                  ///< Pa
  double lambda[n_lanes];              ///< Pa
  std::uint32_t node[4][n_lanes];
};

/// Computes D^-1 and the volume of all batches from reference positions
/// (three per node). Padding lanes keep volume 0. Returns the smallest volume
/// of a real cell, mm^3.
double set_reference(Batch* batches, std::size_t n_batches, std::size_t n_cells,
                     const double* reference);

/// Subtracts the internal nodal forces f_a = V P grad N_a of the neo-Hookean
/// material, P = mu F + (lambda ln J - mu) F^-T, from `force`; returns the
/// smallest J. Where J <= 0 the force is computed at a tiny positive J: the
/// caller has to look at the value returned.
double subtract_neo_hookean(const Batch* batches, std::size_t n_batches, const double* displacement,
                            double* force);

/// The first cell whose J is not above `bound`; n_cells if there is none.
std::size_t find_cell_below(const Batch* batches, std::size_t n_cells, const double* displacement,
                            double bound);

} // namespace prosup::mechanics::kernel

#endif
