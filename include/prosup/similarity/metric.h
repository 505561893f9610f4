#ifndef PROSUP_SIMILARITY_METRIC_H
#define PROSUP_SIMILARITY_METRIC_H

#include <deal.II/base/parameter_handler.h>

#include <cstdint>
#include <string>
#include <vector>

#include "prosup/core/position.h"
#include "prosup/image/voxel_image.h"

namespace prosup::similarity {

/// Both images warped to one unloaded grid, P(X) prone and S(X) supine.
struct WarpedPair {
  image::VoxelGrid grid;
  PerPosition<std::vector<float>> values; ///< of each voxel
  std::vector<std::uint8_t> in_domain;    ///< not 0 in the domain Omega of eq. 12
};

/// Derivatives of the value S of a metric by the intensities of single voxels. All are 0
/// outside the domain.
struct VoxelDerivatives {
  /// dS/dP_v and dS/dS_v, exact.
  PerPosition<std::vector<float>> slope;
  /// d^2 S/dP_v^2 and d^2 S/dS_v^2 with the other image held. Approximated so that it is
  /// never negative (Gauss-Newton, Fisher's information).
  PerPosition<std::vector<float>> curvature;

  /// Sets all derivatives of `n_voxels` voxels to 0.
  void reset(std::size_t n_voxels);
};

/// Residuals of the prone image, slope/curvature^1/2. For the SSD these are
/// h^{3/2} (P - S), whose squares add up to twice the value.
std::vector<float> residuals_of(VoxelDerivatives derivatives);

/// Measures how much two warped images differ: the smaller the value, the more alike they
/// are. A metric sees voxels only, no mesh. To add one, see CONTRIBUTING.md.
class Metric {
public:
  virtual ~Metric() = default;

  /// The name by which it is selected and under which it is reported.
  virtual std::string name() const = 0;

  /// What the name stands for, in the documentation of the parameter.
  virtual std::string description() const { return name(); }

  /// Whether a tissue must have the same intensity in both images. If not, differences
  /// between images say little while the bodies are far apart, and the material update
  /// compares labelled tissues instead.
  virtual bool needs_same_contrast() const = 0;

  /// Declares the parameters of this metric, if any, in a subsection called name().
  virtual void declare_parameters(dealii::ParameterHandler& /*prm*/) {}

  /// Returns the value, mm^3, and computes its derivatives.
  virtual double evaluate(const WarpedPair& pair, VoxelDerivatives& derivatives) const = 0;
};

} // namespace prosup::similarity

#endif
