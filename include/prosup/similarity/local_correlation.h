#ifndef PROSUP_SIMILARITY_LOCAL_CORRELATION_H
#define PROSUP_SIMILARITY_LOCAL_CORRELATION_H

#include "prosup/similarity/metric.h"

namespace prosup::similarity {

/// Squared local correlation as a dissimilarity, for images that depend on each
/// other linearly within a small window, with any slope and sign: neither an
/// inverted contrast nor a bias field matters. Over the windows W_c around all
/// voxels c of the domain,
///   S = c/2 h^3 sum_c (1 - r_c^2),   r_c^2 = cov_c^2/(var_c(P) var_c(S)),
/// with c = `scale`, means over the voxels of W_c in the domain, and the
/// variance of noise added to var_c, so that windows without structure count as
/// uncorrelated, and hardly pull. dS/dP_v is exact: all windows that hold v are
/// differentiated. The slope is linear in P_v but for the moments of the windows;
/// the curvature is its factor, sum_c c h^3 r_c^2/(n_c var_c(P)).
class LocalCorrelation : public Metric {
public:
  /// Brings slopes to the size of those of the ssd: see docs/contrast.md.
  static constexpr double scale = 0.1;

  /// Windows are cubes that reach `window_radius` mm to either side, at least
  /// one voxel; `noise` is the standard deviation of the noise.
  /// @throws Error if either is not positive.
  LocalCorrelation(double window_radius, double noise);

  double evaluate(const WarpedPair& pair, VoxelDerivatives& derivatives) const override;

private:
  double window_radius_, noise_variance_;
};

} // namespace prosup::similarity

#endif
