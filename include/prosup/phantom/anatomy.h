#ifndef PROSUP_PHANTOM_ANATOMY_H
#define PROSUP_PHANTOM_ANATOMY_H

#include <cstdint>

#include "prosup/phantom/geometry.h"
#include "prosup/phantom/smooth_noise.h"

namespace prosup::phantom {

/// The values of the label images.
enum Label : std::uint8_t { air = 0, chest = 1, fat = 2, gland = 3 };

/// The distribution of tissues in the unloaded configuration. Gland is where a random function
/// exceeds a threshold. The function is large in the middle of the breast, and small under the
/// skin and on the chest, where there is always fat.
class Anatomy {
public:
  /// `gland_fraction` is the fraction of the tissue volume that is gland.
  Anatomy(const Geometry& geometry, double gland_fraction, std::uint64_t seed);

  const Geometry& geometry() const { return geometry_; }

  /// Label of a point of the unloaded configuration, LPS mm.
  Label label(const Point<3>& X) const;

  /// Positive in gland and negative in fat, of the order of one. `X` has to lie in the tissue
  /// or near it.
  double gland_level(const Point<3>& X) const { return gland_score(X) - threshold_; }

private:
  double gland_score(const Point<3>& X) const;

  const Geometry geometry_;
  const SmoothNoise shape_, detail_;
  double threshold_ = 0.;
};

} // namespace prosup::phantom

#endif
