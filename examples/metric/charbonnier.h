#ifndef CHARBONNIER_H
#define CHARBONNIER_H

#include <deal.II/base/patterns.h>
#include <prosup/similarity/metric.h>

#include <cmath>

/// Squared differences that are large count as their magnitude only, so that what one image has and
/// the other has not, such as a clip, pulls less (Charbonnier et al., IEEE Trans. Image Process. 6,
/// 298, 1997). With d = P_v - S_v, the width w and the voxel's volume h^3
///   S = h^3 sum_v w^2 (r - 1),  r = (1 + d^2/w^2)^1/2;  dS/dP_v = h^3 d/r = -dS/dS_v.
/// As curvature h^3/r is taken, which is positive and with which a step does not overshoot.
class Charbonnier : public prosup::similarity::Metric {
public:
  std::string name() const override { return "charbonnier"; }
  std::string description() const override { return "differences that are robust to outliers"; }
  bool needs_same_contrast() const override { return true; }

  void declare_parameters(dealii::ParameterHandler& prm) override {
    prm.enter_subsection(name());
    prm.add_parameter("Width", width_,
                      "w, the difference above which two voxels count less. Units: intensity, of "
                      "which images have about 0 to 1.",
                      dealii::Patterns::Double(1e-6));
    prm.leave_subsection();
  }

  double evaluate(const prosup::similarity::WarpedPair& pair,
                  prosup::similarity::VoxelDerivatives& derivatives) const override {
    const double volume = pair.grid.voxel_volume();
    derivatives.reset(pair.in_domain.size());
    double sum = 0.;
    for (std::size_t v = 0; v < pair.in_domain.size(); ++v) {
      if (!pair.in_domain[v])
        continue;
      const double d = pair.values.prone[v] - pair.values.supine[v];
      const double r = std::sqrt(1. + d * d / (width_ * width_));
      sum += width_ * width_ * (r - 1.);
      derivatives.slope.prone[v] = static_cast<float>(volume * d / r);
      derivatives.slope.supine[v] = -derivatives.slope.prone[v];
      derivatives.curvature.prone[v] = derivatives.curvature.supine[v] =
          static_cast<float>(volume / r);
    }
    return volume * sum;
  }

private:
  double width_ = 0.2;
};

#endif
