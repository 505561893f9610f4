#include "line_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "prosup/core/log.h"

namespace prosup::output {

namespace {

constexpr int width = 720, chart_height = 260, left = 80, right = 150, top = 50, gap = 40;

struct Range {
  double low = std::numeric_limits<double>::max(), high = -low;
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Where values lie on the picture.
struct Axes {
  Range x, log_y;
  int upper; ///< y of the upper edge of the chart

  double horizontal(double value) const {
    return left + (value - x.low) / std::max(x.high - x.low, 1e-9) * (width - left - right);
  }
  double vertical(double value) const {
    return upper + (log_y.high - std::log10(value)) / (log_y.high - log_y.low) * chart_height;
  }
};

std::string text(double x, double y, const char* anchor, const std::string& words,
                 const char* more = "") {
  return format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>%s</text>\n", x, y, anchor, more,
                words.c_str());
}

std::string line(double x1, double y1, double x2, double y2, const char* colour) {
  return format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n", x1, y1,
                x2, y2, colour);
}

std::string grid_of(const Axes& axes, const Chart& chart) {
  const double lower = axes.upper + chart_height;
  std::string svg;
  for (double power = std::floor(axes.log_y.low); power <= axes.log_y.high; power += 1.)
    for (const double digit : {1., 2., 5.}) {
      const double value = digit * std::pow(10., power), y = axes.vertical(value);
      if (y < axes.upper - 0.1 || y > lower + 0.1)
        continue;
      svg += line(left, y, width - right, y, "#dddddd");
      svg += text(left - 6, y + 4, "end", format("%g", value));
    }
  svg += line(left, axes.upper, left, lower, "black");
  svg += line(left, lower, width - right, lower, "black");
  const double middle = axes.upper + 0.5 * chart_height;
  return svg + text(18, middle, "middle", chart.y_label,
                    format(" transform=\"rotate(-90 18 %.1f)\"", middle).c_str());
}

std::string curve(const Axes& axes, const Series& series) {
  std::string points, dots;
  for (const auto& [x, y] : series.points) {
    if (!(y > 0.))
      continue;
    points += format("%.1f,%.1f ", axes.horizontal(x), axes.vertical(y));
    dots += format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.5\" fill=\"%s\"/>\n", axes.horizontal(x),
                   axes.vertical(y), series.colour.c_str());
  }
  return format("<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\" points=\"%s\"/>\n",
                series.colour.c_str(), points.c_str()) +
         dots;
}

std::string x_axis(const Axes& axes, const std::string& label) {
  const double lower = axes.upper + chart_height, length = std::max(axes.x.high - axes.x.low, 1e-9);
  const double rough = std::pow(10., std::floor(std::log10(length)));
  const double step = length / rough > 5. ? rough : length / rough > 2. ? 0.5 * rough : 0.2 * rough;
  std::string svg;
  for (double x = std::ceil(axes.x.low / step) * step; x <= axes.x.high + 1e-9; x += step)
    svg += line(axes.horizontal(x), lower, axes.horizontal(x), lower + 4, "black") +
           text(axes.horizontal(x), lower + 18, "middle", format("%g", x));
  return svg + text(0.5 * (left + width - right), lower + 38, "middle", label);
}

} // namespace

std::string svg_of(const std::vector<Chart>& charts, const std::string& title,
                   const std::string& x_label) {
  Range x;
  for (const Chart& chart : charts)
    for (const Series& series : chart.series)
      for (const auto& point : series.points)
        x.include(point.first);
  const int height = top + static_cast<int>(charts.size()) * (chart_height + gap) + 20;
  std::string svg = format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
                           "font-family=\"sans-serif\" font-size=\"12\">\n"
                           "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
                           width, height) +
                    text(left, 28, "start", title, " font-size=\"15\"");
  int upper = top;
  for (std::size_t i = 0; i < charts.size(); ++i, upper += chart_height + gap) {
    Axes axes{x, {}, upper};
    for (const Series& series : charts[i].series)
      for (const auto& point : series.points)
        if (point.second > 0.)
          axes.log_y.include(std::log10(point.second));
    if (axes.log_y.low > axes.log_y.high)
      axes.log_y = {0., 1.};
    const double room = 0.05 + 0.05 * (axes.log_y.high - axes.log_y.low);
    axes.log_y = {axes.log_y.low - room, axes.log_y.high + room};
    svg += grid_of(axes, charts[i]);
    double name_y = upper + 14;
    for (const Series& series : charts[i].series) {
      svg += curve(axes, series);
      svg += text(width - right + 12, name_y, "start", series.name,
                  format(" fill=\"%s\"", series.colour.c_str()).c_str());
      name_y += 18;
    }
    if (i + 1 == charts.size())
      svg += x_axis(axes, x_label);
  }
  return svg + "</svg>\n";
}

} // namespace prosup::output
