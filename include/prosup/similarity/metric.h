#ifndef PROSUP_SIMILARITY_METRIC_H
#define PROSUP_SIMILARITY_METRIC_H

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::similarity {

/// The two states of the body: indices into pairs of anything.
enum State : unsigned { prone = 0, supine = 1 };

inline constexpr const char* state_names[2] = {"prone", "supine"};

/// Both images warped to one unloaded grid: P(X) and S(X), and the voxels that
/// count (the domain Omega of eq. 12).
struct WarpedPair {
  image::VoxelGrid grid;
  std::array<std::vector<float>, 2> values;
  std::vector<std::uint8_t> in_domain;
};

/// How the value of a metric changes with the values of either image at each
/// voxel; all zero outside the domain.
struct VoxelDerivatives {
  /// dS/dP_v and dS/dS_v: exact.
  std::array<std::vector<float>, 2> slope;
  /// d^2 S/dP_v^2 and d^2 S/dS_v^2 with the other image held, as Gauss-Newton or
  /// Fisher's information approximate them: never negative.
  std::array<std::vector<float>, 2> curvature;

  /// All zero, for so many voxels.
  void reset(std::size_t n_voxels);
};

/// slope/curvature^1/2 of the prone image: for the SSD h^{3/2} (P - S), whose squares add up to
/// twice the value.
std::vector<float> residuals_of(VoxelDerivatives derivatives);

/// A measure of the dissimilarity of two warped images: the smaller the more
/// alike. It sees voxels only, no mesh.
class Metric {
public:
  virtual ~Metric() = default;

  /// The value, mm^3, and its derivatives.
  virtual double evaluate(const WarpedPair& pair, VoxelDerivatives& derivatives) const = 0;
};

/// Sum of squared differences, eq. 12: S = 1/2 sum_v (P_v - S_v)^2 h^3, mm^3.
class SumOfSquaredDifferences : public Metric {
public:
  double evaluate(const WarpedPair& pair, VoxelDerivatives& derivatives) const override;
};

/// What metrics other than ssd can be told.
struct MetricParameters {
  unsigned n_bins = 32;      ///< of nmi, for either image
  double window_radius = 2.; ///< of lncc: half the edge of its cubic windows, mm
  double noise = 0.05;       ///< of lncc: standard deviation, images scaled to [0, 1]
};

/// The metrics that can be chosen by name.
const std::vector<std::string>& metric_names();

/// @throws Error that lists the names if there is no metric of this name, and
/// for parameters that the metric cannot work with.
std::unique_ptr<Metric> make_metric(const std::string& name,
                                    const MetricParameters& parameters = {});

} // namespace prosup::similarity

#endif
