#ifndef PROSUP_OUTPUT_CHART_AXES_H
#define PROSUP_OUTPUT_CHART_AXES_H

#include <limits>
#include <string>
#include <vector>

#include "line_chart.h"

namespace prosup::output {

struct Range {
  double low = std::numeric_limits<double>::max(), high = -low;
  void include(double value);
  double length() const;
  /// Makes room on both sides, so that no point lies on the border.
  void widen();
};

/// Values at which an axis whose ends have these decimal logarithms is marked.
std::vector<double> logarithmic_ticks(const Range& log);
std::vector<double> linear_ticks(const Range& range);

/// Where values lie on the picture.
class Axes {
public:
  static constexpr int left = 80;

  /// Axes around all points of a chart; the x axis holds `x`, its logarithms if it is
  /// logarithmic. `upper` is the y of the upper edge.
  Axes(const Range& x, Scale x_scale, const Chart& chart, int upper, int width, int height);

  double horizontal(double value) const;
  double vertical(double value) const;
  double right() const { return left + width_; }
  double upper() const { return upper_; }
  double lower() const { return upper_ + height_; }

  /// Lines and numbers of the y axis, and its name.
  std::string y_axis(const std::string& label) const;
  std::string x_axis(const std::string& label) const;

private:
  Range x_, log_y_;
  Scale x_scale_;
  int upper_, width_, height_;
};

} // namespace prosup::output

#endif
