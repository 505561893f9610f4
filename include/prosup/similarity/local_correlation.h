#ifndef PROSUP_SIMILARITY_LOCAL_CORRELATION_H
#define PROSUP_SIMILARITY_LOCAL_CORRELATION_H

#include "prosup/similarity/metric.h"

namespace prosup::similarity {

/// Squared local correlation, for images that depend linearly on each other within small
/// windows. Slope and sign may differ from window to window, so that neither an inverted
/// contrast nor a bias field matters. With a window W_c around each voxel c of the domain,
///   S = c/2 h^3 sum_c (1 - r_c^2),   r_c^2 = cov_c^2/(var_c(P) var_c(S)),
/// where c = `scale` and the moments are taken over the voxels of W_c in the domain. The
/// variance of the noise is added to var_c, so that windows without structure count as
/// uncorrelated and have small slopes.
///
/// dS/dP_v is exact: it sums over all windows that hold v. The curvature takes the moments
/// of the windows as constant: sum_c c h^3 r_c^2/(n_c var_c(P)), n_c voxels in a window.
class LocalCorrelation : public Metric {
public:
  /// Makes slopes about as large as those of the SSD: see docs/contrast.md.
  static constexpr double scale = 0.1;

  /// `window_radius` is half the edge of the cubic windows, mm, at least one voxel. `noise`
  /// is the standard deviation of the noise in images scaled to [0, 1].
  /// @throws Error if either is not positive.
  explicit LocalCorrelation(double window_radius = 2., double noise = 0.05);

  std::string name() const override { return "lncc"; }
  std::string description() const override { return "squared local correlation"; }
  bool needs_same_contrast() const override { return false; }
  void declare_parameters(dealii::ParameterHandler& prm) override;

  double evaluate(const WarpedPair& pair, VoxelDerivatives& derivatives) const override;

private:
  double window_radius_, noise_;
};

} // namespace prosup::similarity

#endif
