#include "doubts.h"

#include <cmath>

namespace prosup::prepare {

namespace {

constexpr double weak_contrast = 0.1;
constexpr double too_weak = 0.25;                  // share of the chest wall
constexpr double least_separation = 2.;            // standard deviations
constexpr double most_bridged = 2., most_odd = 2.; // cm^2

double share_of_weak_edge(const ChestWall& wall) {
  const TrunkGrid& grid = wall.surface.grid;
  std::size_t n = 0, n_weak = 0;
  for (std::size_t column = 0; column < wall.edge.size(); ++column) {
    if (std::abs(grid.angle(column % grid.n_columns)) > widest_breast ||
        wall.edge[column] == ChestWall::no_edge)
      continue;
    ++n;
    n_weak += wall.edge[column] < weak_contrast;
  }
  return n == 0 ? 0. : double(n_weak) / double(n); // a mask of the user has no edges
}

/// "x = 12, y = -30, z = 5 mm".
std::string place(const Departure& departure) {
  const Point<3>& p = departure.position;
  return format("x = %.0f, y = %.0f, z = %.0f mm (LPS)", p[0], p[1], p[2]);
}

void doubt_shape(const ChestWall& wall, std::vector<std::string>& doubts) {
  if (wall.bridged.area > most_bridged)
    doubts.push_back(
        format("tissue that looks like muscle stands up to %.0f mm out of the chest on %.0f cm^2, "
               "at most at %s; it was taken as gland, and the chest wall behind it was continued "
               "from its surroundings: look at the green line there.",
               wall.bridged.largest, wall.bridged.area, place(wall.bridged).c_str()));
  if (wall.departure.area > most_odd)
    doubts.push_back(format(
        "the chest wall lies up to %.0f mm %s a smooth chest on %.0f cm^2, at most at %s; "
        "look at the green line there, and give a mask of the chest if it is wrong.",
        std::abs(wall.departure.largest), wall.departure.largest > 0. ? "in front of" : "behind",
        wall.departure.area, place(wall.departure).c_str()));
}

} // namespace

Confidence judge(const ChestWall& wall, const Tissues& tissues) {
  Confidence confidence;
  confidence.weak_edge = share_of_weak_edge(wall);
  confidence.bridged_area = wall.bridged.area;
  confidence.odd_area = wall.departure.area;
  confidence.separation = tissues.separation();
  std::vector<std::string>& doubts = confidence.doubts;
  if (wall.fat.is_doubtful)
    doubts.push_back(
        std::string("it is not clear whether fat is bright or suppressed; it was taken as ") +
        (wall.fat.is_bright ? "bright" : "suppressed") +
        ", and 'Preparation/Contrast' says which is right.");
  if (confidence.weak_edge > too_weak)
    doubts.push_back(format(
        "the chest wall has little contrast on %.0f %% of its front; look at the green line in "
        "the pictures, and correct the labels where it is wrong.",
        100. * confidence.weak_edge));
  doubt_shape(wall, doubts);
  if (confidence.separation < least_separation)
    doubts.push_back(
        format("fat and gland differ by %.1f standard deviations only; look at the red lines in "
               "the pictures.",
               confidence.separation));
  return confidence;
}

} // namespace prosup::prepare
