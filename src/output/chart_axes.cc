#include "chart_axes.h"

#include <algorithm>
#include <cmath>

#include "svg.h"

namespace prosup::output {

void Range::include(double value) {
  low = std::min(low, value);
  high = std::max(high, value);
}

double Range::length() const {
  return std::max(high - low, 1e-9);
}

void Range::widen() {
  if (low > high)
    *this = {0., 1.};
  const double room = 0.05 + 0.05 * (high - low);
  *this = {low - room, high + room};
}

std::vector<double> linear_ticks(const Range& range) {
  const double length = range.length(), rough = std::pow(10., std::floor(std::log10(length)));
  const double step = length / rough > 5. ? rough : length / rough > 2. ? 0.5 * rough : 0.2 * rough;
  std::vector<double> ticks;
  // Multiples, so that 0 is 0 and not what is left of a sum.
  for (double n = std::ceil(range.low / step); n * step <= range.high + 1e-9; n += 1.)
    ticks.push_back(n * step);
  return ticks;
}

std::vector<double> logarithmic_ticks(const Range& log) {
  constexpr std::size_t n_enough = 3;
  std::vector<double> ticks;
  for (const auto& digits :
       {std::vector<double>{1., 2., 5.}, std::vector<double>{1., 2., 3., 4., 5., 6., 7., 8., 9.}}) {
    ticks.clear();
    for (double power = std::floor(log.low); power <= log.high; power += 1.)
      for (const double digit : digits) {
        const double value = digit * std::pow(10., power), at = std::log10(value);
        if (at >= log.low - 1e-3 && at <= log.high + 1e-3)
          ticks.push_back(value);
      }
    if (ticks.size() >= n_enough)
      return ticks;
  }
  return linear_ticks({std::pow(10., log.low), std::pow(10., log.high)});
}

Axes::Axes(const Range& x, Scale x_scale, const Chart& chart, int upper, int width, int height)
    : x_(x), x_scale_(x_scale), upper_(upper), width_(width), height_(height) {
  for (const Series& series : chart.series)
    for (const auto& point : series.points)
      if (point.second > 0.)
        log_y_.include(std::log10(point.second));
  log_y_.widen();
}

double Axes::horizontal(double value) const {
  const double at = x_scale_ == Scale::logarithmic ? std::log10(value) : value;
  return left + (at - x_.low) / x_.length() * width_;
}

double Axes::vertical(double value) const {
  return upper_ + (log_y_.high - std::log10(value)) / log_y_.length() * height_;
}

std::string Axes::y_axis(const std::string& label) const {
  std::string picture;
  for (const double value : logarithmic_ticks(log_y_)) {
    picture += svg::line(left, vertical(value), right(), vertical(value), "#dddddd");
    picture += svg::text(left - 6, vertical(value) + 4, "end", format("%g", value));
  }
  picture += svg::line(left, upper(), left, lower(), "black");
  picture += svg::line(left, lower(), right(), lower(), "black");
  const double middle = 0.5 * (upper() + lower());
  return picture + svg::text(18, middle, "middle", label,
                             format(" transform=\"rotate(-90 18 %.1f)\"", middle));
}

std::string Axes::x_axis(const std::string& label) const {
  std::string picture;
  for (const double x : x_scale_ == Scale::logarithmic ? logarithmic_ticks(x_) : linear_ticks(x_)) {
    picture += svg::line(horizontal(x), lower(), horizontal(x), lower() + 4, "black");
    picture += svg::text(horizontal(x), lower() + 18, "middle", format("%g", x));
  }
  return picture + svg::text(0.5 * (left + right()), lower() + 38, "middle", label);
}

} // namespace prosup::output
