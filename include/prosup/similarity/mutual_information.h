#ifndef PROSUP_SIMILARITY_MUTUAL_INFORMATION_H
#define PROSUP_SIMILARITY_MUTUAL_INFORMATION_H

#include "prosup/similarity/metric.h"

namespace prosup::similarity {

/// Normalised mutual information (Studholme, Hill and Hawkes, Pattern
/// Recognition 32, 1999) as a dissimilarity, for images of which the
/// intensities of one tell those of the other:
///   S = c V (2 - NMI),   NMI = (H_P + H_S)/H_PS in [1, 2],
/// V being the volume of the domain (mm^3) and c = `scale`. The entropies are
/// those of a joint histogram p_ij of cubic B-splines (Parzen windows; Thevenaz
/// and Unser, IEEE Trans. Image Process. 9, 2000), so that S is a smooth function
/// of the intensities. It is the surface
///   M(P, S) = sum_ij B_i(P) B_j(S) (NMI log p_ij - log p_i - log p_j)
/// that pulls: dS/dP_v = -c h^3/H_PS dM/dP, exact. As curvature stands Fisher's
/// information: the mean of (dM/dP)^2 over the voxels with a like intensity of the
/// other image, c h^3/H_PS times. Intensities beyond the range of the histogram,
/// that of image::rescale(), count as its end, with no slope.
class NormalisedMutualInformation : public Metric {
public:
  /// Brings slopes to the size of those of the ssd: see docs/contrast.md.
  static constexpr double scale = 0.25;

  /// `n_bins` of either image. @throws Error for fewer than 8 or more than 256.
  explicit NormalisedMutualInformation(unsigned n_bins);

  double evaluate(const WarpedPair& pair, VoxelDerivatives& derivatives) const override;

private:
  unsigned n_bins_;
};

} // namespace prosup::similarity

#endif
