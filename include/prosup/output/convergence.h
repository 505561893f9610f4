#ifndef PROSUP_OUTPUT_CONVERGENCE_H
#define PROSUP_OUTPUT_CONVERGENCE_H

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/evaluation/target_registration_error.h"

namespace prosup::output {

/// One evaluation during a registration.
struct ConvergenceEntry {
  std::string stage;         ///< unloading, material or image_forces
  double level_mm = 0.;      ///< of the similarity grid
  unsigned iteration = 0;    ///< in its stage and level
  double seconds = 0.;       ///< of the run, without the evaluation of landmarks
  double similarity = 0.;    ///< value of the metric: comparable within a level only
  double shear_modulus = 0.; ///< Pa
  double poisson_ratio = 0., gland_ratio = 0.;
  double chest_stiffness = 0.;                      ///< Pa/mm
  double force_weight = 0.;                         ///< kappa, Pa
  std::optional<evaluation::ErrorStatistics> error; ///< mm
};

/// Writes one row per evaluation as CSV.
/// @throws Error if the file cannot be written.
void write_convergence(const std::vector<ConvergenceEntry>& entries,
                       const std::filesystem::path& file);

/// Writes an SVG picture of the similarity, relative to the first value of its level, and of the
/// error where it is known, against time (Fig. 11 of the paper).
/// @throws Error if the file cannot be written.
void write_convergence_picture(const std::vector<ConvergenceEntry>& entries,
                               const std::filesystem::path& file);

} // namespace prosup::output

#endif
