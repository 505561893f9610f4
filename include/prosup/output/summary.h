#ifndef PROSUP_OUTPUT_SUMMARY_H
#define PROSUP_OUTPUT_SUMMARY_H

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "prosup/core/position.h"
#include "prosup/evaluation/target_registration_error.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::output {

/// Numbers of one breast.
struct BreastSummary {
  std::size_t n_cells = 0;
  std::size_t n_nodes = 0;
  double min_quality = 0.;
  /// Smallest and largest J = det F of a cell.
  std::optional<double> min_jacobian, max_jacobian;
};

/// Numbers of a mesh, and of its deformation.
BreastSummary summarize(const mesh::UnloadedMesh& mesh);

/// One evaluation of the image similarity.
struct SimilarityEntry {
  std::string stage; ///< unloading, material or image_forces
  double level_mm = 0.;
  unsigned iteration = 0;
  double value = 0.; ///< of the metric
};

/// How the supine chest was aligned with the prone one.
struct AlignmentSummary {
  std::string method;
  std::array<double, 3> translation;      ///< of the chest surface's centre, LPS, mm
  std::array<double, 3> rotation_degrees; ///< axis times angle
  double surface_before = 0.;             ///< median distance of the chest surfaces, mm
  double surface_after = 0.;
  std::optional<std::array<double, 2>> information; ///< mutual, before and after, nats
};

/// What was found in a scan.
struct PreparationSummary {
  std::string contrast;                      ///< as the parameter
  double fat_volume = 0., gland_volume = 0.; ///< ml
  double weak_edge = 0.;    ///< share of the chest wall under the breasts with little contrast
  double bridged_area = 0.; ///< of the wall, continued behind tissue that looks like muscle, cm^2
  double odd_area = 0.;     ///< of the wall, far from a smooth chest, cm^2
  double unknown_contact = 0.;     ///< cm^2 on which tissue ends because the scan shows no more
  double separation = 0.;          ///< of fat and gland, in standard deviations
  std::vector<std::string> doubts; ///< one sentence each
};

/// How far a registration can be trusted.
struct QualitySummary {
  std::string verdict;              ///< good, doubtful or failed
  std::vector<std::string> reasons; ///< why it is not good, one sentence each
  /// Numbers by their names; a dot in a name makes a group.
  std::vector<std::pair<std::string, double>> figures;
};

/// The contents of `summary.json`. Entries that are not set are left out.
struct Summary {
  std::string command;
  unsigned ranks = 1;
  PerPosition<std::optional<BreastSummary>> breasts;
  PerPosition<std::optional<PreparationSummary>> preparation;
  std::optional<AlignmentSummary> alignment;
  std::optional<std::size_t> steps;  ///< explicit time steps of all stages
  std::optional<std::string> metric; ///< of the similarity
  std::vector<SimilarityEntry> similarity;

  std::optional<double> shear_modulus; ///< Pa
  std::optional<double> lambda;        ///< Pa
  std::optional<double> poisson_ratio, gland_ratio;
  std::optional<double> skin_stiffness;      ///< Pa mm
  std::optional<double> chest_stiffness;     ///< Pa/mm
  std::optional<double> lateral_chest_ratio; ///< of the chest stiffness, side over front
  std::optional<PerPosition<double>> cut_plane_stiffness; ///< Pa/mm
  std::optional<std::array<double, 2>> supine_tilt; ///< of gravity to the left and head, degrees

  /// Target registration errors after each stage, mm; absent without landmarks.
  struct Errors {
    std::optional<evaluation::ErrorStatistics> initial, unloaded, material, image_forces;
  } tre;

  /// Distance after mapping the nodes of the prone mesh to supine and back, mm.
  std::optional<evaluation::ErrorStatistics> inverse_consistency;

  /// Wall times of the stages, s; absent where a stage did not run.
  struct Times {
    std::optional<double> mesh, unloading, material, image_forces;
    double total = 0.;
  } time;

  std::optional<QualitySummary> quality;
  double peak_memory = 0.; ///< MiB
  bool converged = false;
  std::vector<std::string> warnings;
};

/// Writes a summary and the version of the library as JSON.
/// @throws Error if the file cannot be written, or if a number is not finite; the message names the
/// entry, and no file is written.
void write_summary(const Summary& summary, const std::filesystem::path& file);

/// The table of registration errors, one row per step; empty without landmarks.
std::string error_table(const Summary& summary);

/// The verdict and its reasons, one line each; empty if there is none.
std::string verdict_text(const Summary& summary);

} // namespace prosup::output

#endif
