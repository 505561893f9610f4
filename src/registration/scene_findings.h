#ifndef PROSUP_REGISTRATION_SCENE_FINDINGS_H
#define PROSUP_REGISTRATION_SCENE_FINDINGS_H

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "prosup/registration/scene_check.h"
#include "scene_breast.h"
#include "scene_pair.h"

namespace prosup::registration {

/// How the images of a pair are used.
struct SceneOptions {
  bool needs_same_contrast = false; ///< so does the metric
  bool is_aligned = false;          ///< the chests have been aligned by section "Pre-alignment"
};

inline Finding error(std::string text) {
  return {Finding::Severity::error, std::move(text)};
}
inline Finding warning(std::string text) {
  return {Finding::Severity::warning, std::move(text)};
}
/// Error beyond one limit, warning beyond another one.
inline Finding finding(bool is_error, std::string text) {
  return {is_error ? Finding::Severity::error : Finding::Severity::warning, std::move(text)};
}

using Findings = std::vector<Finding>;
bool has_error(const Findings& findings);

/// Faults of the labels of one breast.
Findings findings_of(const BreastMeasures& breast, Position position, const Labels& meaning);

/// Whether gravity points off the chest in prone, and onto it in supine.
Findings gravity_findings_of(const BreastMeasures& breast, Position position,
                             const dealii::Tensor<1, 3>& gravity);

/// Faults of two breasts that are right each for itself.
Findings findings_of(const PerPosition<BreastMeasures>& breasts, const PairMeasures& pair,
                     const PerPosition<dealii::Tensor<1, 3>>& gravity, const SceneOptions& options);

/// Faults that two images show beside their labels.
Findings image_findings_of(const PairMeasures& pair, const SceneOptions& options);

/// A table of what was measured.
std::string table_of(const PerPosition<BreastMeasures>& breasts,
                     const PerPosition<dealii::Tensor<1, 3>>& gravity);
std::string table_of(const PairMeasures& pair);

} // namespace prosup::registration

#endif
