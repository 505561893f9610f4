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

/// A measure of the dissimilarity of two warped images: the smaller the more
/// alike. It sees voxels only, no mesh.
class Metric {
public:
  virtual ~Metric() = default;

  /// The value, and in `derivatives` its derivatives by the values of either
  /// image at each voxel (zero outside the domain).
  virtual double evaluate(const WarpedPair& pair,
                          std::array<std::vector<float>, 2>& derivatives) const = 0;
};

/// Sum of squared differences, eq. 12: S = 1/2 sum_v (P_v - S_v)^2 h^3, mm^3.
class SumOfSquaredDifferences : public Metric {
public:
  double evaluate(const WarpedPair& pair,
                  std::array<std::vector<float>, 2>& derivatives) const override;
};

/// The metrics that can be chosen by name.
const std::vector<std::string>& metric_names();

/// @throws Error that lists the names if there is no metric of this name.
std::unique_ptr<Metric> make_metric(const std::string& name);

} // namespace prosup::similarity

#endif
