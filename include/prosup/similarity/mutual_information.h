#ifndef PROSUP_SIMILARITY_MUTUAL_INFORMATION_H
#define PROSUP_SIMILARITY_MUTUAL_INFORMATION_H

#include "prosup/similarity/metric.h"

namespace prosup::similarity {

/// Normalised mutual information (Studholme, Hill and Hawkes, Pattern Recognition 32,
/// 1999) as a dissimilarity, for images where the intensity of one predicts that of the
/// other:
///   S = c V (2 - NMI),   NMI = (H_P + H_S)/H_PS in [1, 2],
/// where V is the volume of the domain, mm^3, and c = `scale`. H are the entropies of a
/// joint histogram p_ij of cubic B-splines (Parzen windows; Thevenaz and Unser, IEEE Trans.
/// Image Process. 9, 2000), which makes S a smooth function of the intensities.
///
/// The exact slope is dS/dP_v = -c h^3/H_PS dM/dP, with the surface
///   M(P, S) = sum_ij B_i(P) B_j(S) (NMI log p_ij - log p_i - log p_j).
/// The curvature is Fisher's information: c h^3/H_PS times the mean of (dM/dP)^2 over the
/// voxels in the same bin of the other image. Intensities outside the range of the
/// histogram, which is that of image::rescale(), count as its end and have no slope.
class NormalisedMutualInformation : public Metric {
public:
  /// Makes slopes about as large as those of the SSD: see docs/contrast.md.
  static constexpr double scale = 0.25;

  /// `n_bins` for each image. @throws Error for fewer than 8 or more than 256.
  explicit NormalisedMutualInformation(unsigned n_bins = 32);

  std::string name() const override { return "nmi"; }
  std::string description() const override { return "normalised mutual information"; }
  bool needs_same_contrast() const override { return false; }
  void declare_parameters(dealii::ParameterHandler& prm) override;

  double evaluate(const WarpedPair& pair, VoxelDerivatives& derivatives) const override;

private:
  unsigned n_bins_;
};

} // namespace prosup::similarity

#endif
