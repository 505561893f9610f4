#include "prosup/registration/similarity_setup.h"

#include <algorithm>

#include "prosup/image/filters.h"
#include "prosup/similarity/domain.h"

namespace prosup::registration {

using namespace dealii;

SimilaritySetup::SimilaritySetup() : ParameterAcceptor("Similarity") {
  add_parameter("Metric", metric_,
                "Measure of the dissimilarity of the two images. Allowed: ssd (sum of squared "
                "differences, paper eq. 12).",
                prm,
                Patterns::Selection(Patterns::Tools::Convert<std::vector<std::string>>::to_string(
                    similarity::metric_names())));
  add_parameter("Boundary layers", n_layers_,
                "Layers of voxels around the mesh that are mapped like their nearest element, so "
                "that the skin feels the whole of its image edge. Units: voxels.",
                prm, Patterns::Integer(0, 20));
  add_parameter("Grid margin", margin_,
                "Space that the common unloaded grid leaves around both meshes. Units: mm.", prm,
                Patterns::Double(0., 1000.));
}

void SimilaritySetup::prepare(MPI_Comm world) {
  force_ = std::make_shared<similarity::ImageForce>(similarity::make_metric(metric_), world);
}

similarity::SimilarityDomain
SimilaritySetup::domain(const BodyPair& pair, const std::array<image::LabelImage, 2>& labels,
                        unsigned chest_label, double level) const {
  const image::VoxelGrid grid = similarity::common_unloaded_grid(
      pair.loaded_states(), level, margin_, pair.ranks().world());
  return similarity::similarity_domain(grid, {&labels[0], &labels[1]}, chest_label, n_layers_);
}

std::array<image::ScalarImage, 2> SimilaritySetup::images(const BodyPair& pair,
                                                          double level) const {
  std::array<image::ScalarImage, 2> smoothed;
  for (const State state : {similarity::prone, similarity::supine})
    if (pair.ranks().holds(state)) {
      const image::ScalarImage& image = pair[state].image;
      const auto& spacing = image.grid.spacing;
      const double finest = std::min({spacing[0], spacing[1], spacing[2]});
      // Half a voxel of blur per voxel of the coarser grid avoids aliasing.
      smoothed[state] = level > 1.5 * finest ? image::gaussian_smooth(image, 0.5 * level) : image;
    }
  return smoothed;
}

} // namespace prosup::registration
