#include "prosup/output/convergence.h"

#include "line_chart.h"
#include "prosup/core/log.h"
#include "prosup/core/text_file.h"

namespace prosup::output {

namespace {

const char* colour_of(const std::string& stage) {
  return stage == "material" ? "#1b7837" : "#2166ac";
}

std::string name_of(const ConvergenceEntry& entry) {
  return (entry.stage == "material" ? "material, " : "forces, ") + format("%g mm", entry.level_mm);
}

} // namespace

void write_convergence(const std::vector<ConvergenceEntry>& entries,
                       const std::filesystem::path& file) {
  std::string text = "stage,level_mm,iteration,seconds,similarity,shear_modulus_Pa,poisson_ratio,"
                     "gland_ratio,chest_stiffness_Pa_per_mm,force_weight_Pa,tre_mean_mm,"
                     "tre_p95_mm,tre_max_mm\n";
  for (const ConvergenceEntry& e : entries) {
    text += format("%s,%g,%u,%.2f,%.8g,%.6g,%.5g,%.5g,%.5g,%.6g,", e.stage.c_str(), e.level_mm,
                   e.iteration, e.seconds, e.similarity, e.shear_modulus, e.poisson_ratio,
                   e.gland_ratio, e.chest_stiffness, e.force_weight);
    text +=
        e.error ? format("%.4f,%.4f,%.4f\n", e.error->mean, e.error->p95, e.error->max) : ",,\n";
  }
  write_text_file(text, file);
}

void write_convergence_picture(const std::vector<ConvergenceEntry>& entries,
                               const std::filesystem::path& file) {
  Chart similarity{"similarity over its first value", {}}, error{"error, mm", {}};
  error.series = {{"mean", "#b2182b", {}}, {"p95", "#ef8a62", {}}, {"max", "#999999", {}}};
  double first = 0.;
  for (const ConvergenceEntry& entry : entries) {
    if (similarity.series.empty() || similarity.series.back().name != name_of(entry)) {
      similarity.series.push_back({name_of(entry), colour_of(entry.stage), {}});
      first = entry.similarity;
    }
    if (first > 0.)
      similarity.series.back().points.emplace_back(entry.seconds, entry.similarity / first);
    if (entry.error) {
      error.series[0].points.emplace_back(entry.seconds, entry.error->mean);
      error.series[1].points.emplace_back(entry.seconds, entry.error->p95);
      error.series[2].points.emplace_back(entry.seconds, entry.error->max);
    }
  }
  std::vector<Chart> charts{similarity};
  if (!error.series[0].points.empty())
    charts.push_back(error);
  write_text_file(svg_of(charts, "Similarity and error along the registration", "time, s"), file);
}

} // namespace prosup::output
