#include "point_labels.h"

#include <algorithm>

#include "svg.h"

namespace prosup::output {

namespace {

constexpr double letter_width = 5.6, letter_height = 10., distance = 7.; // pixels, font size 10

} // namespace

void PointLabels::occupy(double x, double y, double radius) {
  taken_.push_back({x - radius, y - radius, x + radius, y + radius});
}

bool PointLabels::is_free(const Box& box) const {
  return box.left >= left_ && box.right <= right_ &&
         std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
           return box.left < other.right && other.left < box.right && box.upper < other.lower &&
                  other.upper < box.lower;
         });
}

std::string PointLabels::place(double x, double y, const std::string& words,
                               const std::string& colour) {
  const double width = letter_width * static_cast<double>(words.size());
  const double high = 0.5 * letter_height;
  const double near = 0.5 * distance;
  // Above first: lines mostly fall to the right.
  const Box boxes[] = {
      {x + near, y - near - letter_height, x + near + width, y - near},
      {x + distance, y - high, x + distance + width, y + high},
      {x - near - width, y + near, x - near, y + near + letter_height},
      {x - distance - width, y - high, x - distance, y + high},
      {x - 0.5 * width, y + distance, x + 0.5 * width, y + distance + letter_height}};
  for (const Box& box : boxes)
    if (is_free(box)) {
      taken_.push_back(box);
      return svg::text(box.left, box.lower - 1., "start", words,
                       " font-size=\"10\" fill=\"" + colour + "\"");
    }
  return {};
}

} // namespace prosup::output
