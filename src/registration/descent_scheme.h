#ifndef PROSUP_SRC_REGISTRATION_DESCENT_SCHEME_H
#define PROSUP_SRC_REGISTRATION_DESCENT_SCHEME_H

#include <memory>
#include <string>
#include <vector>

#include "image_energy.h"

namespace prosup::registration {

/// Where to go from a point so that phi falls.
class DescentScheme {
public:
  virtual ~DescentScheme() = default;

  /// Whether it uses the stiffness of the images.
  virtual bool needs_stiffness() const { return false; }
  /// Whether directions depend on the steps before.
  virtual bool remembers_steps() const { return false; }
  virtual PairVectors direction(const ImageEnergyPoint& point, double kappa) = 0;
  /// Length of the first step tried along a direction, after one of `last`.
  virtual double first_length(double) const { return 1.; }
  /// Part of it below which a direction is given up.
  virtual double shortest_part() const { return 1e-6; }
  /// Told of each step that is taken.
  virtual void accept(const ImageEnergyPoint&, const ImageEnergyPoint&) {}
};

/// The schemes that can be chosen by name.
const std::vector<std::string>& descent_scheme_names();

/// @throws Error if there is no scheme of that name. Keeps a reference to the energy.
std::unique_ptr<DescentScheme> make_descent_scheme(const std::string& name,
                                                   const ImageEnergy& energy);

} // namespace prosup::registration

#endif
