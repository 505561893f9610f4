#ifndef PROSUP_REGISTRATION_SEARCHED_PROPERTY_H
#define PROSUP_REGISTRATION_SEARCHED_PROPERTY_H

#include <vector>

#include "prosup/registration/mechanical_properties.h"

namespace prosup::registration {

/// A property as a number q without bounds near it, what is allowed of it, and what is known of it
/// before any image is seen: a normal distribution of q.
struct SearchedProperty {
  const char* name;
  double (*get)(const MechanicalProperties&);
  void (*set)(MechanicalProperties&, double q);
  double difference;   ///< of q for derivatives
  double longest_step; ///< of q
  double low, high;    ///< of q
  double mean, deviation;
  bool may_be_low = false; ///< the low end is plausible
  bool is_subtle = false;  ///< seen only once the others are nearly right: on the finest level
  /// If not 0: the deviation of q from that of the property before, which is of the same name.
  double alike = 0.;

  /// Minus the logarithm of its prior probability, but for a constant.
  double surprise(const MechanicalProperties& properties) const {
    const double distance = (get(properties) - mean) / deviation;
    return 0.5 * distance * distance;
  }
};

/// All of them, with numbers of one name behind each other.
const std::vector<SearchedProperty>& searched_properties();

} // namespace prosup::registration

#endif
