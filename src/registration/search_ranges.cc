#include "prosup/registration/search_ranges.h"

#include "searched_property.h"

namespace prosup::registration {

SearchRanges search_ranges() {
  SearchRanges ranges;
  for (const SearchedProperty& property : searched_properties()) {
    property.set(ranges.from, property.low);
    property.set(ranges.to, property.high);
  }
  return ranges;
}

} // namespace prosup::registration
