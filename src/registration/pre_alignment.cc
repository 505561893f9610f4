#include "prosup/registration/pre_alignment.h"

#include <deal.II/base/numbers.h>

#include "prosup/core/log.h"
#include "prosup/core/parameters.h"
#include "prosup/image/filters.h"

namespace prosup::registration {

using namespace dealii;
using image::DegreesOfFreedom;
using image::LabelImage;
using image::ScalarImage;
using similarity::prone;
using similarity::supine;

namespace {

const std::vector<std::string>& freedom_names() {
  static const std::vector<std::string> names = {"translation", "rigid"};
  return names;
}

constexpr double sigma_voxels = 2.;
constexpr double cover = 2.; // mm below the surface where moving tissue shines through

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
  prm.add_parameter("Method", method_,
                    "What the supine chest wall is rigidly aligned by with the prone one. none: it "
                    "lies there already. chest surface: the surfaces of the chest labels. chest "
                    "intensities: these, and mutual information of the images in the chest wall "
                    "for what the surfaces leave open. Units: none.",
                    Patterns::Selection("none|chest surface|chest intensities"));
  prm.add_parameter("Degrees of freedom", freedom_,
                    "What may be changed: translation, or rigid (rotation as well). Units: none.",
                    one_of(freedom_names()));
  prm.add_parameter("Depth", depth_,
                    "Thickness of the layer below the surface of the chest label whose intensities "
                    "are compared: the chest wall with its ribs, and not the organs, which move. "
                    "Units: mm.",
                    Patterns::Double(3., 1000.));
  prm.add_parameter(
      "Reach", reach_,
      "How far along the surface of the chest the intensities are searched; ribs look "
      "alike after one distance from rib to rib, so that more than half of it is "
      "risky. Units: mm.",
      Patterns::Double(0., 100.));
}

Alignment PreAlignment::run(const ScalarImage& prone_image, const ScalarImage& supine_image,
                            const similarity::Scene& scene) const {
  std::array<LabelImage, 2> chest;
  std::array<ScalarImage, 2> distance;
  for (const auto state : {prone, supine}) {
    distance[state] =
        image::signed_distance(image::select_labels(scene.labels[state], {scene.chest_label}));
    chest[state] = layer(distance[state], depth_);
    // The stairs of the voxels would look like a shape that holds the surfaces.
    distance[state] = image::gaussian_smooth(
        distance[state], sigma_voxels * std::cbrt(distance[state].grid.voxel_volume()));
  }
  Alignment result;
  result.method = method_;
  const auto align_surfaces = [&](DegreesOfFreedom freedom) {
    result.surface =
        image::align_surfaces(distance[prone], distance[supine], freedom, result.transform);
    result.transform = result.surface.transform;
  };
  const auto align_intensities = [&](double reach) {
    if (method_ == "chest surface")
      return;
    result.intensities =
        image::align_intensities({prone_image, chest[prone]}, {supine_image, chest[supine]},
                                 result.transform, result.surface.open, reach);
    result.transform = result.intensities->transform;
  };
  align_surfaces(DegreesOfFreedom::translation);
  const double distance_before = result.surface.distance_before;
  align_intensities(reach_);
  if (freedom_ == "rigid") {
    align_surfaces(DegreesOfFreedom::rigid);
    align_surfaces(DegreesOfFreedom::translation);
    align_intensities(0.);
  }
  result.surface.distance_before = distance_before;
  return result;
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
    text += format(", free to slide in %zu direction%s", surface.open.size(),
                   surface.open.size() == 1 ? "" : "s");
  if (intensities)
    text += format("\n  mutual information in the chest wall: %.3f -> %.3f",
                   intensities->information_before, intensities->information_after);
  return text;
}

} // namespace prosup::registration
