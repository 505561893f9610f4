#include "prosup/registration/similarity_setup.h"

#include "compared_images.h"
#include "prosup/similarity/sum_of_squared_differences.h"

namespace prosup::registration {

SimilaritySetup::SimilaritySetup(const similarity::SimilarityParameters& parameters, MPI_Comm world)
    : world_(world), parameters_(parameters), metric_(parameters.make_metric()),
      force_(metric_, world) {}

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
  return {metric().name(), force_, domain(pair, scene, level), images(pair, level)};
}

Comparison SimilaritySetup::of_tissues(const BodyPair& pair, const similarity::Scene& scene,
                                       double level) const {
  const auto metric = std::make_shared<similarity::SumOfSquaredDifferences>();
  Comparison result{metric->name() + " of tissues",
                    similarity::ImageForce(metric, world_),
                    domain(pair, scene, level),
                    {}};
  result.domain.air = {0.f, 0.f};
  for (const State state : {similarity::prone, similarity::supine})
    if (pair.ranks().holds(state))
      result.images[state] = smoothed(tissue_image(scene.labels[state], scene.gland_label), level);
  return result;
}

} // namespace prosup::registration
