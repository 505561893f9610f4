#ifndef PROSUP_OUTPUT_LINE_CHART_H
#define PROSUP_OUTPUT_LINE_CHART_H

#include <string>
#include <utility>
#include <vector>

namespace prosup::output {

/// Points joined by lines, in the order given.
struct Series {
  std::string name, colour; ///< colour as SVG has it
  std::vector<std::pair<double, double>> points;
};

/// A chart with a logarithmic y axis; values that are not positive are left out.
struct Chart {
  std::string y_label;
  std::vector<Series> series;
};

/// Charts below each other over one x axis, as SVG.
std::string svg_of(const std::vector<Chart>& charts, const std::string& title,
                   const std::string& x_label);

} // namespace prosup::output

#endif
