#include "colours.h"

#include <algorithm>
#include <cmath>

namespace prosup::output {

namespace {

Colour between(const Colour& a, const Colour& b, double share) {
  Colour mixed;
  for (unsigned c = 0; c < 3; ++c)
    mixed[c] = static_cast<std::uint8_t>(std::lround(a[c] + share * (double(b[c]) - a[c])));
  return mixed;
}

} // namespace

Colour blue_white_red(double value) {
  constexpr Colour blue{33, 80, 190}, white{255, 255, 255}, red{190, 30, 45};
  return between(white, value < 0. ? blue : red, std::min(std::abs(value), 1.));
}

Colour dark_to_bright(double value) {
  constexpr std::array<Colour, 5> stops{
      {{48, 18, 90}, {58, 82, 139}, {33, 144, 140}, {110, 200, 95}, {250, 230, 60}}};
  const double place = std::clamp(value, 0., 1.) * double(stops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return between(stops[low], stops[low + 1], place - double(low));
}

} // namespace prosup::output
