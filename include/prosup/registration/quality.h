#ifndef PROSUP_REGISTRATION_QUALITY_H
#define PROSUP_REGISTRATION_QUALITY_H

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "prosup/mesh/deformation.h"
#include "prosup/registration/agreement.h"
#include "prosup/registration/mechanical_properties.h"

namespace prosup::registration {

/// How the prone breast gets to supine.
struct Motion {
  double mean = 0.;          ///< of the distances, mm
  double along_gravity = 0.; ///< mean of the parts along the change of gravity, mm
};

/// What tells a good registration from a wrong one without knowing the truth.
struct Quality {
  bool converged = false;
  bool same_contrast = true;               ///< the metric needs it, Metric::needs_same_contrast()
  std::vector<std::string> scene_findings; ///< what the check of the scene said, one sentence each
  MechanicalProperties properties;
  std::vector<std::string> at_bound; ///< MaterialUpdateResult::at_bound
  PerPosition<mesh::JacobianRange> jacobian;
  PerPosition<double> unloaded_quality; ///< smallest radius ratio of an unloaded cell
  ChestMisfit chest;
  Motion motion;
  double inverse_p95 = 0.; ///< 95th percentile of the inverse consistency, mm
  /// After the stages that were run, in their order.
  std::optional<Agreement> unloaded, material, image_forces;
};

/// The numbers of a Quality that a summary has nowhere else: "chest.median" and the like.
std::vector<std::pair<std::string, double>> figures_of(const Quality& quality);

} // namespace prosup::registration

#endif
