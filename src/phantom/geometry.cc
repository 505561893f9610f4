#include "prosup/phantom/geometry.h"

#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::phantom {

void Geometry::check() const {
  if (!(chest_radius > 0.5 * width))
    throw Error(
        format("The phantom's chest is too narrow: 'Phantom/Anatomy/Chest radius' is %g mm but has "
               "to be more than half of 'Width' (%g mm); make the radius larger or "
               "the width smaller.",
               chest_radius, width));
}

double Geometry::chest_y(double x) const {
  return chest_radius - std::sqrt(chest_radius * chest_radius - x * x);
}

double Geometry::thickness(double x, double z) const {
  return layer + height * std::exp(-(x * x + z * z) / (2. * sigma * sigma));
}

bool Geometry::in_tissue(const Point<3>& X) const {
  if (std::abs(X[0]) > 0.5 * width || std::abs(X[2]) > 0.5 * length)
    return false;
  return X[1] <= chest_y(X[0]) && X[1] >= skin_y(X[0], X[2]);
}

double Geometry::depth(const Point<3>& X) const {
  const double x = X[0], z = X[2];
  const double slope = (thickness(x, z) - layer) / (sigma * sigma);
  const double along_x = x / std::sqrt(chest_radius * chest_radius - x * x) + slope * x;
  return (X[1] - skin_y(x, z)) / std::hypot(1., along_x, slope * z);
}

double Geometry::distance_to_chest(const Point<3>& x) const {
  return std::hypot(x[0], x[1] - chest_radius) - chest_radius;
}

double Geometry::volume() const {
  const auto integral = [&](double extent) {
    return sigma * std::sqrt(2. * M_PI) * std::erf(extent / (2. * std::sqrt(2.) * sigma));
  };
  return layer * width * length + height * integral(width) * integral(length);
}

} // namespace prosup::phantom
