#ifndef PROSUP_SRC_EVALUATION_COORDINATE_SYSTEM_H
#define PROSUP_SRC_EVALUATION_COORDINATE_SYSTEM_H

#include <deal.II/base/point.h>

#include <string>

namespace prosup::evaluation {

/// The coordinate systems in which points are accepted.
enum class CoordinateSystem { lps, ras };

/// The system that a file calls `name`: LPS, RAS, or 1 and 0 of older versions of 3D Slicer.
/// @throws Error that starts with "In `where`" if it is another one.
CoordinateSystem coordinate_system(const std::string& name, const std::string& where);

/// `p` in LPS.
inline dealii::Point<3> to_lps(const dealii::Point<3>& p, CoordinateSystem system) {
  return system == CoordinateSystem::lps ? p : dealii::Point<3>(-p[0], -p[1], p[2]);
}

/// @throws Error that starts with "In `where`" if `value` is no position in mm: not finite, or
/// more than a kilometre, with which no arithmetic of a breast is exact.
void check_coordinate(double value, const std::string& where);

} // namespace prosup::evaluation

#endif
