#include "line_chart.h"

#include <algorithm>
#include <cmath>

#include "chart_axes.h"
#include "point_labels.h"
#include "svg.h"

namespace prosup::output {

namespace {

constexpr int top = 50, gap = 40;

/// Sizes in pixels. A picture of one chart makes it larger.
struct Layout {
  int width, height; ///< of a chart
  int right;         ///< room for the names
};

Layout layout_of(const std::vector<Chart>& charts) {
  std::size_t longest = 0;
  for (const Chart& chart : charts)
    for (const Series& series : chart.series)
      longest = std::max(longest, series.name.size());
  const int right = std::max(150, 40 + 7 * static_cast<int>(longest));
  return charts.size() == 1 ? Layout{600, 400, right} : Layout{490, 260, right};
}

std::string curve(const Axes& axes, const Series& series) {
  const bool is_dashed = series.style == Style::dashes;
  std::string points, signs;
  for (const auto& [x, y] : series.points) {
    const double h = axes.horizontal(x), v = y > 0. ? axes.vertical(y) : NAN;
    if (!std::isfinite(h) || !std::isfinite(v))
      continue;
    points += format("%.1f,%.1f ", h, v);
    if (!is_dashed)
      signs += svg::marker(series.marker, h, v, series.style == Style::markers ? 4.5 : 2.5,
                           series.colour);
  }
  return format("<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"%s\"%s points=\"%s\"/>\n",
                series.colour.c_str(), series.style == Style::markers ? "1" : "1.5",
                is_dashed ? " stroke-dasharray=\"5,4\"" : "", points.c_str()) +
         signs;
}

/// The names of the series, right of the chart.
std::string names_of(const Axes& axes, const Chart& chart) {
  std::string picture;
  double y = axes.upper() + 14;
  for (const Series& series : chart.series) {
    if (series.style == Style::dashes)
      continue;
    double x = axes.right() + 12;
    if (series.style == Style::markers) {
      picture += svg::marker(series.marker, x + 4, y - 4, 4.5, series.colour);
      x += 14;
    }
    picture += svg::text(x, y, "start", series.name, " fill=\"" + series.colour + "\"");
    y += 18;
  }
  return picture;
}

std::string labels_of(const Axes& axes, const Chart& chart) {
  PointLabels labels(Axes::left, axes.right());
  for (const Series& series : chart.series)
    for (const auto& [x, y] : series.points)
      if (series.style == Style::markers && y > 0.)
        labels.occupy(axes.horizontal(x), axes.vertical(y), 5.);
  std::string picture;
  for (const Series& series : chart.series)
    for (std::size_t i = 0; i < series.labels.size(); ++i)
      if (const auto& [x, y] = series.points[i]; y > 0.)
        picture +=
            labels.place(axes.horizontal(x), axes.vertical(y), series.labels[i], series.colour);
  return picture;
}

Range x_range(const std::vector<Chart>& charts, Scale scale) {
  Range x;
  for (const Chart& chart : charts)
    for (const Series& series : chart.series)
      for (const auto& point : series.points)
        if (scale == Scale::linear)
          x.include(point.first);
        else if (point.first > 0.)
          x.include(std::log10(point.first));
  if (scale == Scale::logarithmic || x.low > x.high)
    x.widen();
  return x;
}

} // namespace

std::string svg_of(const std::vector<Chart>& charts, const std::string& title,
                   const std::string& x_label, Scale x_scale) {
  const Range x = x_range(charts, x_scale);
  const Layout layout = layout_of(charts);
  const int height = top + static_cast<int>(charts.size()) * (layout.height + gap) + 20;
  std::string picture = svg::start(Axes::left + layout.width + layout.right, height,
                                   " font-family=\"sans-serif\" font-size=\"12\"") +
                        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" +
                        svg::text(Axes::left, 28, "start", title, " font-size=\"15\"");
  int upper = top;
  for (std::size_t i = 0; i < charts.size(); ++i, upper += layout.height + gap) {
    const Axes axes(x, x_scale, charts[i], upper, layout.width, layout.height);
    picture += axes.y_axis(charts[i].y_label);
    for (const Series& series : charts[i].series)
      picture += curve(axes, series);
    picture += names_of(axes, charts[i]) + labels_of(axes, charts[i]);
    if (i + 1 == charts.size())
      picture += axes.x_axis(x_label);
  }
  return picture + "</svg>\n";
}

} // namespace prosup::output
