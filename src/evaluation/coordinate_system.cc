#include "coordinate_system.h"

#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "text_input.h"

namespace prosup::evaluation {

CoordinateSystem coordinate_system(const std::string& name, const std::string& where) {
  const std::string system = lower_case(name);
  if (system == "lps" || system == "1")
    return CoordinateSystem::lps;
  if (system == "ras" || system == "0")
    return CoordinateSystem::ras;
  throw Error("In " + where + ": the coordinate system '" + shown(name) +
              "' is not supported; save the points in LPS or RAS.");
}

void check_coordinate(double value, const std::string& where) {
  constexpr double kilometre = 1e6;
  if (!(std::abs(value) <= kilometre))
    throw Error(
        "In " + where +
        format(": the coordinate %g is no position in mm; give one between -1e6 and 1e6.", value));
}

} // namespace prosup::evaluation
