#ifndef PROSUP_CORE_UNITS_H
#define PROSUP_CORE_UNITS_H

namespace prosup {

// Lengths are in mm, masses in g, times in s. One g/(mm s^2) is exactly one
// pascal, so that stresses need no conversion. Coordinates are LPS: x to the
// patient's left, y to posterior, z to superior.

/// Acceleration of gravity, mm/s^2.
constexpr double standard_gravity = 9810.;

/// Mass density of soft tissue, g/mm^3 (1000 kg/m^3).
constexpr double tissue_density = 1e-3;

} // namespace prosup

#endif
