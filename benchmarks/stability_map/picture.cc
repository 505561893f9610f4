#include "picture.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/log.h"
#include "prosup/core/text_file.h"

namespace prosup::benchmarks {

namespace {

constexpr int field_width = 30, field_height = 22;
constexpr int left = 64, top = 64, gap = 16, header = 20, footer = 60, n_columns = 5;

/// The different values of a property, in the order in which they come.
template <typename Property>
auto values_of(const std::vector<Run>& runs, Property property) {
  std::vector<decltype(property(runs.front()))> values;
  for (const Run& run : runs)
    if (std::find(values.begin(), values.end(), property(run)) == values.end())
      values.push_back(property(run));
  return values;
}

template <typename T>
int place(const std::vector<T>& values, const T& value) {
  return static_cast<int>(std::find(values.begin(), values.end(), value) - values.begin());
}

/// Green, paler the more steps it took; red; grey.
std::string colour(const Run& run) {
  switch (run.outcome) {
  case Outcome::converged: {
    const double slow = std::clamp(std::log10(run.n_steps / 100.) / 2., 0., 1.);
    const auto level = [slow](double fast, double pale) {
      return static_cast<int>(fast + slow * (pale - fast));
    };
    return format("rgb(%d,%d,%d)", level(60, 205), level(160, 232), level(90, 205));
  }
  case Outcome::unsettled:
    return "rgb(200,200,200)";
  case Outcome::diverged:
    break;
  }
  return "rgb(205,80,70)";
}

std::string label(double x, double y, const std::string& text, const char* more = "") {
  return format("<text x=\"%g\" y=\"%g\" %s>%s</text>\n", x, y, more, text.c_str());
}

std::string steps(const Run& run) {
  if (run.outcome != Outcome::converged)
    return "";
  return run.n_steps < 1000 ? std::to_string(run.n_steps) : format("%.1fk", 1e-3 * run.n_steps);
}

/// All panels and what is common to them.
class Map {
public:
  explicit Map(const std::vector<Run>& runs)
      : runs_(runs), softness_(values_of(runs, [](const Run& r) { return r.softness; })),
        damping_(values_of(runs, [](const Run& r) { return r.damping_factor; })),
        correction_(values_of(runs, [](const Run& r) { return r.correction.name(); })),
        prone_(values_of(runs, [](const Run& r) { return r.prone; })),
        panel_width_(field_width * static_cast<int>(damping_.size()) + gap),
        panel_height_(field_height * static_cast<int>(softness_.size()) + header + gap),
        n_rows_((static_cast<int>(correction_.size()) + n_columns - 1) / n_columns) {}

  std::string svg() const {
    const int width =
        left + panel_width_ * std::min(n_columns, static_cast<int>(correction_.size()));
    const int height = top + panel_height_ * n_rows_ * static_cast<int>(prone_.size()) + footer;
    std::string text =
        format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
               "font-family=\"sans-serif\" font-size=\"11\">\n"
               "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
               width, height);
    text += label(left, 24, "Unloading of a breast-like body: what converges",
                  "font-size=\"16\" font-weight=\"bold\"");
    text += label(left, 42,
                  "green: converged, with its number of steps; red: diverged; grey: not settled");
    for (const Run& run : runs_)
      text += field(run);
    for (const bool prone : prone_)
      text += axes(prone);
    text += label(left, height - 14,
                  "Across in each panel: damping (r/rho)/(2 omega_1). Down: softness rho g L/mu.");
    return text + "</svg>\n";
  }

private:
  /// Upper left corner of the fields of a panel.
  int x(const std::string& correction) const {
    return left + panel_width_ * (place(correction_, correction) % n_columns);
  }
  int y(bool prone, const std::string& correction) const {
    const int row = n_rows_ * place(prone_, prone) + place(correction_, correction) / n_columns;
    return top + header + panel_height_ * row;
  }

  std::string field(const Run& run) const {
    const int x0 = x(run.correction.name()) + field_width * place(damping_, run.damping_factor);
    const int y0 =
        y(run.prone, run.correction.name()) + field_height * place(softness_, run.softness);
    return format("<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"%s\" "
                  "stroke=\"white\"/>\n",
                  x0, y0, field_width, field_height, colour(run).c_str()) +
           label(x0 + field_width / 2., y0 + 15., steps(run),
                 "text-anchor=\"middle\" font-size=\"9\"");
  }

  std::string axes(bool prone) const {
    std::string text;
    for (const std::string& name : correction_) {
      const int x0 = x(name), y0 = y(prone, name);
      const int below = y0 + field_height * static_cast<int>(softness_.size()) + 12;
      text += label(x0, y0 - 6, (prone ? "prone, " : "supine, ") + name);
      for (const double d : damping_)
        text += label(x0 + field_width * (place(damping_, d) + 0.5), below, format("%g", d),
                      "text-anchor=\"middle\"");
      if (x0 == left)
        for (const double s : softness_)
          text += label(left - 6, y0 + field_height * place(softness_, s) + 15, format("%g", s),
                        "text-anchor=\"end\"");
    }
    return text;
  }

  const std::vector<Run>& runs_;
  const std::vector<double> softness_, damping_;
  const std::vector<std::string> correction_;
  const std::vector<bool> prone_;
  const int panel_width_, panel_height_, n_rows_;
};

} // namespace

void write_picture(const std::vector<Run>& runs, const std::filesystem::path& file) {
  write_text_file(Map(runs).svg(), file);
}

} // namespace prosup::benchmarks
