#ifndef PROSUP_SRC_PIPELINE_SHOWN_PROPERTIES_H
#define PROSUP_SRC_PIPELINE_SHOWN_PROPERTIES_H

#include <vector>

#include "prosup/registration/search_ranges.h"

namespace prosup::pipeline {

/// A mechanical property that is shown, by its place in `material` of summary.json.
struct ShownProperty {
  const char *pointer, *name, *unit;
  double (*get)(const registration::MechanicalProperties&);
};

/// All but the tilt of gravity, which has two values.
const std::vector<ShownProperty>& shown_properties();

} // namespace prosup::pipeline

#endif
