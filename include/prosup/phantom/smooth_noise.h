#ifndef PROSUP_PHANTOM_SMOOTH_NOISE_H
#define PROSUP_PHANTOM_SMOOTH_NOISE_H

#include <deal.II/base/point.h>

#include <vector>

#include "prosup/phantom/random.h"

namespace prosup::phantom {

/// A smooth random function of space with mean 0 and standard deviation 1: a cubic B-spline on
/// a cubic lattice with independent, normally distributed coefficients. It is twice
/// continuously differentiable and repeats after 32 lattice spacings.
class SmoothNoise {
public:
  /// `spacing` of the lattice is in mm; features are about twice as wide.
  SmoothNoise(double spacing, std::uint64_t seed, Stream stream, unsigned part = 0);

  double operator()(const dealii::Point<3>& position) const;

private:
  double spacing_;
  std::vector<float> coefficients_;
};

} // namespace prosup::phantom

#endif
