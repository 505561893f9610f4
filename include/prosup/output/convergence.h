#ifndef PROSUP_OUTPUT_CONVERGENCE_H
#define PROSUP_OUTPUT_CONVERGENCE_H

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/evaluation/target_registration_error.h"

namespace prosup::output {

/// A state along a registration.
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

/// One row per state. @throws Error if the file cannot be written.
void write_convergence(const std::vector<ConvergenceEntry>& entries,
                       const std::filesystem::path& file);

/// The similarity of each level over its first value, and the error where it is
/// known, over time (paper's Fig. 11), as SVG. @throws as above.
void write_convergence_picture(const std::vector<ConvergenceEntry>& entries,
                               const std::filesystem::path& file);

} // namespace prosup::output

#endif
