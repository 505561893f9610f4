#include "prosup/registration/pre_alignment.h"

#include <deal.II/base/numbers.h>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/parameters.h"
#include "prosup/image/filters.h"
#include "prosup/registration/quality.h"

namespace prosup::registration {

using namespace dealii;
using image::DegreesOfFreedom;
using image::LabelImage;
using image::ScalarImage;

namespace {

const std::vector<std::string>& freedom_names() {
  static const std::vector<std::string> names = {"translation", "rigid"};
  return names;
}

constexpr double sigma_voxels = 2.;
// Automatic: chests that are less apart than this (median) may be so by their masks, which are off
// by 1 mm, and by ribs that move by up to 4 mm.
constexpr double most_within_masks = 1.5; // mm
// Further apart than this, scans are not those of one patient in one coordinate system.
constexpr double farthest_that_fits = 2., longest_shift = 15.; // mm
constexpr double largest_turn = 0.2;                           // 11 degrees
constexpr double cover = 2.; // mm below the surface that tissue outside the chest blurs

/// The layer of a mask that lies from `cover` to `depth` below its surface.
LabelImage layer(const ScalarImage& distance, double depth) {
  LabelImage result(distance.grid);
  for (std::size_t v = 0; v < result.values.size(); ++v)
    result.values[v] = distance.values[v] < -cover && distance.values[v] > -depth;
  return result;
}

} // namespace

PreAlignment::PreAlignment() : ParameterAcceptor("Pre-alignment") {}

void PreAlignment::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter(
      "Method", method_,
      "How to align the supine chest wall with the prone one, by a rigid motion. "
      "none: it is aligned already. automatic: by the surfaces of the chest labels "
      "if these are more than 1.5 mm apart and fit after a motion of at most 15 mm "
      "and 11 degrees. chest surface: by the surfaces of the chest "
      "labels in any case. chest intensities: by the surfaces, and then, along directions in "
      "which these can slide, by the mutual information of the images in the chest "
      "wall.",
      Patterns::Selection("none|automatic|chest surface|chest intensities"));
  prm.add_parameter("Degrees of freedom", freedom_,
                    "translation, or rigid: translation and rotation.", one_of(freedom_names()));
  prm.add_parameter("Layer depth", layer_depth_,
                    "Depth below the surface of the chest label down to which intensities are "
                    "compared. The layer should hold the chest wall with its ribs, but not the "
                    "organs, which move. Units: mm.",
                    Patterns::Double(3., 1000.));
  prm.add_parameter("Search distance", search_distance_,
                    "Longest translation along the surface of the chest that chest intensities "
                    "tries. It should be below half the distance between two ribs, since one rib "
                    "looks like the next. Units: mm.",
                    Patterns::Double(0., 100.));
}

Alignment PreAlignment::aligned(const ScalarImage& prone_image, const ScalarImage& supine_image,
                                const similarity::Scene& scene) const {
  PerPosition<LabelImage> chest;
  PerPosition<ScalarImage> distance;
  for (const Position position : both_positions) {
    distance[position] =
        image::signed_distance(image::select_labels(scene.labels[position], {scene.chest_label}));
    chest[position] = layer(distance[position], layer_depth_);
    // Otherwise the stair steps of the voxels would lock the surfaces in place.
    distance[position] = image::gaussian_smooth(
        distance[position], sigma_voxels * std::cbrt(distance[position].grid.voxel_volume()));
  }
  Alignment result;
  result.method = method_;
  const auto align_surfaces = [&](DegreesOfFreedom freedom) {
    result.surface =
        image::align_surfaces(distance.prone, distance.supine, freedom, result.transform);
    result.transform = result.surface.transform;
  };
  const auto align_intensities = [&](double search_distance) {
    if (method_ != "chest intensities")
      return;
    result.intensities =
        image::align_intensities({prone_image, chest.prone}, {supine_image, chest.supine},
                                 result.transform, result.surface.open, search_distance);
    result.transform = result.intensities->transform;
  };
  align_surfaces(DegreesOfFreedom::translation);
  const double distance_before = result.surface.distance_before;
  align_intensities(search_distance_);
  if (freedom_ == "rigid") {
    align_surfaces(DegreesOfFreedom::rigid);
    align_surfaces(DegreesOfFreedom::translation);
    align_intensities(0.);
  }
  result.surface.distance_before = distance_before;
  return result;
}

std::optional<Alignment> PreAlignment::run(const ScalarImage& prone_image,
                                           const ScalarImage& supine_image,
                                           const similarity::Scene& scene) const {
  if (method_ != "automatic")
    return aligned(prone_image, supine_image, scene);
  if (measure_chest_misfit(scene).median < most_within_masks)
    return {};
  try {
    Alignment alignment = aligned(prone_image, supine_image, scene);
    if (alignment.surface.distance_after < farthest_that_fits &&
        alignment.transform.translation.norm() < longest_shift &&
        alignment.transform.rotation_vector().norm() < largest_turn)
      return alignment;
  } catch (const Error&) { // no surface in common: the check of the scene says so
  }
  return {};
}

std::string describe(const Alignment& alignment) {
  const auto& [surface, intensities] = std::tie(alignment.surface, alignment.intensities);
  const Tensor<1, 3>& shift = alignment.transform.translation;
  const Tensor<1, 3> turn = 180. / numbers::PI * alignment.transform.rotation_vector();
  std::string text =
      format("  supine moved by (%.2f, %.2f, %.2f) mm, turned by (%.2f, %.2f, %.2f) degrees\n"
             "  chest surfaces: %.2f -> %.2f mm apart (median of %zu points)",
             shift[0], shift[1], shift[2], turn[0], turn[1], turn[2], surface.distance_before,
             surface.distance_after, surface.n_points);
  if (!surface.open.empty())
    text += format(", can slide along each other in %zu direction%s", surface.open.size(),
                   surface.open.size() == 1 ? "" : "s");
  if (intensities)
    text += format("\n  mutual information in the chest wall: %.3f -> %.3f",
                   intensities->information_before, intensities->information_after);
  return text;
}

} // namespace prosup::registration
