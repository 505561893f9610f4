#include "prosup/registration/similarity_setup.h"

#include "compared_images.h"
#include "prosup/core/parameters.h"

namespace prosup::registration {

using namespace dealii;

SimilarityParameters::SimilarityParameters() : ParameterAcceptor("Similarity") {}

void SimilarityParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter(
      "Metric", metric,
      "Measure of the dissimilarity of the two images. Allowed: ssd (sum of squared "
      "differences, paper eq. 12), nmi (normalised mutual information), lncc (squared local "
      "correlation); the latter two for images of different contrast, such as MR and CT.",
      one_of(similarity::metric_names()));
  prm.add_parameter("Bins", metric_parameters.n_bins,
                    "Of the joint histogram of nmi, for either image. Units: none.",
                    Patterns::Integer(8, 256));
  prm.add_parameter(
      "Window radius", metric_parameters.window_radius,
      "Half the edge of the cubic windows of lncc, at least one voxel: small ones, which "
      "rarely hold air, fat and gland at once, do best. Units: mm.",
      Patterns::Double(0.1, 1000.));
  prm.add_parameter("Noise", metric_parameters.noise,
                    "Standard deviation of the noise for lncc: what varies less within a window "
                    "hardly counts. Units: none (images are scaled to [0, 1]).",
                    Patterns::Double(1e-6, 1.));
  prm.add_parameter(
      "Boundary layers", n_layers,
      "Layers of voxels around the mesh that are mapped like their nearest element, so "
      "that the skin feels the whole of its image edge. Units: voxels.",
      Patterns::Integer(0, 20));
  prm.add_parameter("Grid margin", margin,
                    "Space that the common unloaded grid leaves around both meshes. Units: voxels.",
                    Patterns::Double(0., 1000.));
}

SimilaritySetup::SimilaritySetup(const SimilarityParameters& parameters, MPI_Comm world)
    : world_(world), parameters_(parameters),
      force_(similarity::make_metric(parameters.metric, parameters.metric_parameters), world) {}

similarity::SimilarityDomain
SimilaritySetup::domain(const BodyPair& pair, const similarity::Scene& scene, double level) const {
  const image::VoxelGrid grid = similarity::common_unloaded_grid(
      pair.loaded_states(), level, parameters_.margin * level, pair.ranks().world());
  return similarity::similarity_domain(grid, scene, parameters_.n_layers);
}

std::array<image::ScalarImage, 2> SimilaritySetup::images(const BodyPair& pair,
                                                          double level) const {
  std::array<image::ScalarImage, 2> images;
  for (const State state : {similarity::prone, similarity::supine})
    if (pair.ranks().holds(state))
      images[state] = smoothed(pair[state].image, level);
  return images;
}

Comparison SimilaritySetup::of_images(const BodyPair& pair, const similarity::Scene& scene,
                                      double level) const {
  return {metric(), force_, domain(pair, scene, level), images(pair, level)};
}

Comparison SimilaritySetup::of_tissues(const BodyPair& pair, const similarity::Scene& scene,
                                       double level) const {
  Comparison result{"ssd of tissues",
                    similarity::ImageForce(similarity::make_metric("ssd"), world_),
                    domain(pair, scene, level),
                    {}};
  result.domain.air = {0.f, 0.f};
  for (const State state : {similarity::prone, similarity::supine})
    if (pair.ranks().holds(state))
      result.images[state] = smoothed(tissue_image(scene.labels[state], scene.gland_label), level);
  return result;
}

} // namespace prosup::registration
