#ifndef PROSUP_OUTPUT_LINE_CHART_H
#define PROSUP_OUTPUT_LINE_CHART_H

#include <string>
#include <utility>
#include <vector>

namespace prosup::output {

enum class Style {
  dots,    ///< small dots, joined in the order given
  markers, ///< large signs, joined likewise
  dashes   ///< a line without signs, and not in the list of names
};

struct Series {
  std::string name, colour; ///< colour as SVG has it
  std::vector<std::pair<double, double>> points;
  Style style = Style::dots;
  unsigned marker = 0;                  ///< shape of the sign
  std::vector<std::string> labels = {}; ///< of the points, shown where there is room; or none
};

/// A chart with a logarithmic y axis; values that are not positive are left out.
struct Chart {
  std::string y_label;
  std::vector<Series> series;
};

enum class Scale { linear, logarithmic };

/// Charts below each other over one x axis, as SVG. On a logarithmic axis, points whose
/// x is not positive are left out as well.
std::string svg_of(const std::vector<Chart>& charts, const std::string& title,
                   const std::string& x_label, Scale x_scale = Scale::linear);

} // namespace prosup::output

#endif
