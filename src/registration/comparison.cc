#include "prosup/registration/comparison.h"

#include <algorithm>
#include <utility>

#include "prosup/image/filters.h"
#include "prosup/similarity/sum_of_squared_differences.h"

namespace prosup::registration {

using image::ScalarImage;
using similarity::Samples;
using similarity::SimilarityDomain;

namespace {

/// An image smoothed for voxels of edge `level` mm: half a voxel of blur avoids aliasing.
ScalarImage smoothed(const ScalarImage& image, double level) {
  const auto& spacing = image.grid.spacing;
  const double finest = std::min({spacing[0], spacing[1], spacing[2]});
  return level > 1.5 * finest ? image::gaussian_smooth(image, 0.5 * level) : image;
}

/// Air 0, gland 1, all else 1/2: the chest wall looks like fat, no edge that the tissue could be
/// pulled to.
ScalarImage tissue_image(const image::LabelImage& labels, unsigned gland_label) {
  ScalarImage tissue(labels.grid);
  std::transform(labels.values.begin(), labels.values.end(), tissue.values.begin(),
                 [&](unsigned label) {
                   return label == 0 ? 0.f : label == gland_label ? 1.f : 0.5f;
                 });
  return tissue;
}

SimilarityDomain domain_of(const BreastPair& pair, const ComparedImages& compared, double level,
                           const image::VoxelGrid& given) {
  similarity::Box box;
  bool all_voxels_sampled = true;
  pair.for_each([&](Position, Breast& breast) {
    box.include(breast.unloaded_box());
    all_voxels_sampled = all_voxels_sampled && breast.samples_surroundings();
  });
  const double margin = all_voxels_sampled ? 1. : compared.margin;
  const image::VoxelGrid grid =
      given.n_voxels() > 0
          ? given
          : similarity::common_grid(box, level, margin * level, pair.ranks().world());
  if (all_voxels_sampled) {
    SimilarityDomain domain;
    domain.grid = grid;
    return domain;
  }
  return similarity::similarity_domain(grid, compared.scene, compared.n_layers);
}

} // namespace

Comparison::Comparison(const BreastPair& pair, const ComparedImages& compared, Compared by,
                       double level, const image::VoxelGrid& grid)
    : pair_(pair), level_(level), domain_(domain_of(pair, compared, level, grid)) {
  const bool by_images = by == Compared::images;
  metric_ =
      by_images ? compared.metric : std::make_shared<const similarity::SumOfSquaredDifferences>();
  name_ = by_images ? metric_->name() : "ssd of tissues";
  if (!by_images)
    domain_.air = {0.f, 0.f};
  for (const Position position : both_positions)
    if (pair.ranks().holds(position))
      images_[position] = smoothed(
          by_images ? compared.images[position]
                    : tissue_image(compared.scene.labels[position], compared.scene.gland_label),
          level);
}

similarity::Dissimilarity Comparison::evaluate() const {
  PerPosition<const Samples*> samples;
  pair_.for_each([&](Position position, Breast& breast) {
    samples[position] = &breast.sample(domain_, images_[position]);
  });
  return similarity::evaluate(*metric_, domain_, samples, pair_.ranks().world());
}

double Comparison::value() const {
  return evaluate().value;
}

std::vector<float> Comparison::residuals() const {
  return similarity::residuals_of(evaluate().derivatives);
}

double Comparison::set_image_forces(similarity::Variable variable) const {
  const similarity::Dissimilarity found = evaluate();
  pair_.for_each([&](Position position, Breast& breast) {
    breast.set_image_forces(found.derivatives.slope[position], variable);
  });
  return found.value;
}

} // namespace prosup::registration
