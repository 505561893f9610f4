#ifndef PROSUP_SIMILARITY_SUM_OF_SQUARED_DIFFERENCES_H
#define PROSUP_SIMILARITY_SUM_OF_SQUARED_DIFFERENCES_H

#include "prosup/similarity/metric.h"

namespace prosup::similarity {

/// Sum of squared differences, eq. 12 of the paper, for images of the same contrast:
///   S = 1/2 h^3 sum_v (P_v - S_v)^2,
/// v being the voxels of the domain and h^3 their volume, mm^3.
///   dS/dP_v = h^3 (P_v - S_v) = -dS/dS_v, and both curvatures are h^3.
class SumOfSquaredDifferences : public Metric {
public:
  std::string name() const override { return "ssd"; }
  std::string description() const override { return "sum of squared differences, paper eq. 12"; }
  bool needs_same_contrast() const override { return true; }

  double evaluate(const WarpedPair& pair, VoxelDerivatives& derivatives) const override;
};

} // namespace prosup::similarity

#endif
