#include "report_charts.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "html.h"
#include "line_chart.h"
#include "prosup/core/log.h"
#include "prosup/evaluation/landmarks_csv.h"
#include "svg.h"

namespace prosup::output {

namespace {

constexpr const char *blue = "#2166ac", *green = "#1b7837", *grey = "#666666";

/// Without what only a file needs.
std::string inlined(const std::string& svg) {
  const std::size_t start = svg.find("<svg");
  return "<figure>" + svg.substr(start == std::string::npos ? 0 : start) + "</figure>\n";
}

std::string bars(const std::vector<unsigned>& counts, double width_mm) {
  constexpr double left = 50., bottom = 180., height = 150., bar = 34.;
  const unsigned most = *std::max_element(counts.begin(), counts.end());
  const double right = left + bar * double(counts.size());
  std::string svg = svg::start(int(right) + 30, 230,
                               " font-family=\"sans-serif\" font-size=\"11\" role=\"img\" "
                               "aria-label=\"histogram of the errors\"");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double h = height * double(counts[i]) / double(most), x = left + bar * double(i);
    svg += format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>\n",
                  x + 1., bottom - h, bar - 2., h, blue);
    if (counts[i] > 0)
      svg += svg::text(x + bar / 2., bottom - h - 4., "middle", std::to_string(counts[i]));
    svg += svg::text(x, bottom + 15., "middle", format("%g", width_mm * double(i)));
  }
  svg += svg::text(right, bottom + 15., "middle", format("%g", width_mm * double(counts.size())));
  svg += svg::line(left, bottom, right, bottom, grey);
  svg += svg::text((left + right) / 2., bottom + 35., "middle",
                   "landmarks by their error after the registration, mm");
  return svg + "</svg>\n";
}

} // namespace

std::string similarity_chart(const nlohmann::json& entries) {
  Chart chart{"similarity over its first value", {}};
  double first = 0., level_start = 1., reached = 1., count = 0.;
  std::string last_name;
  for (const auto& entry : entries) {
    const std::string stage = entry.value("stage", "");
    const double value = entry.value("value", 0.);
    const std::string name = (stage == "material" ? "properties, " : "forces, ") +
                             format("%g mm", entry.value("level_mm", 0.));
    const bool begins = name != last_name;
    if (begins) {
      chart.series.push_back({name, stage == "material" ? green : blue, {}});
      chart.series.back().marker = unsigned(chart.series.size());
      first = value;
      level_start = reached;
      last_name = name;
    }
    if (first > 0.)
      reached = level_start * value / first;
    // A level begins with the state in which the one before has ended.
    if (!begins || chart.series.size() == 1)
      count += 1.;
    chart.series.back().points.emplace_back(count, reached);
  }
  if (chart.series.empty())
    return "<p>The images were not compared.</p>\n";
  return "<p>Each level goes on where the one before has ended, since values are comparable within "
         "a level only. Lower is more alike.</p>\n" +
         inlined(svg_of({chart}, "Gain along the registration", "accepted state"));
}

std::string error_histogram(const std::filesystem::path& landmarks) {
  if (!std::filesystem::exists(landmarks))
    return "";
  std::vector<evaluation::LandmarkError> errors = evaluation::read_errors(landmarks);
  std::sort(errors.begin(), errors.end(),
            [](const auto& a, const auto& b) { return a.error > b.error; });
  constexpr double widths[] = {0.05, 0.1, 0.2, 0.5, 1., 2., 5., 10.};
  constexpr double most_bars = 14.;
  double width = 20.;
  for (const double candidate : widths)
    if (errors.front().error <= most_bars * candidate) {
      width = candidate;
      break;
    }
  std::vector<unsigned> counts(std::size_t(errors.front().error / width) + 1, 0);
  for (const evaluation::LandmarkError& landmark : errors)
    ++counts[std::size_t(landmark.error / width)];
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < std::min<std::size_t>(errors.size(), 5); ++i)
    rows.push_back({errors[i].id, format("%.2f", errors[i].error)});
  return inlined(bars(counts, width)) + "<p>The largest errors:</p>\n" +
         html::table({"landmark", "mm"}, rows);
}

} // namespace prosup::output
