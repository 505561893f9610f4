#ifndef PROSUP_REGISTRATION_SEARCH_RANGES_H
#define PROSUP_REGISTRATION_SEARCH_RANGES_H

#include "prosup/registration/mechanical_properties.h"

namespace prosup::registration {

/// Between what values the properties are searched; one of both may be the larger one.
struct SearchRanges {
  MechanicalProperties from, to;
};

SearchRanges search_ranges();

} // namespace prosup::registration

#endif
