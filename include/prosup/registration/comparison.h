#ifndef PROSUP_REGISTRATION_COMPARISON_H
#define PROSUP_REGISTRATION_COMPARISON_H

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "prosup/image/voxel_image.h"
#include "prosup/registration/breast_pair.h"
#include "prosup/similarity/domain.h"
#include "prosup/similarity/metric.h"

namespace prosup::registration {

/// One comparison of the two breasts along a registration.
struct SimilarityRecord {
  std::string stage;
  double level = 0.; ///< edge of the voxels of the common grid, mm
  unsigned iteration = 0;
  double force_weight = 0.; ///< kappa, Pa; 0 where no image force acts
  double value = 0.;        ///< of the metric
};

/// Told, on all ranks, of each state that a registration goes on from, when the pair has it.
using Observer = std::function<void(const SimilarityRecord&)>;

/// Told, on all ranks, of each point from which a stage could go on in another process.
using Keeper = std::function<void()>;

/// What two unloaded breasts are compared by.
enum class Compared {
  images, ///< by the chosen metric
  /// The labels, as images with air 0, fat 1/2 and gland 1, by squared differences: what all images
  /// have in common, whatever their contrast, and smooth however far apart the breasts are.
  tissues
};

/// What can be compared of a pair. Refers to objects that have to live as long.
struct ComparedImages {
  const PerPosition<image::ScalarImage>& images; ///< loaded, scaled to [0, 1], of the held breasts
  const similarity::Scene& scene;
  std::shared_ptr<const similarity::Metric> metric; ///< of the images
  unsigned n_layers = 2;                            ///< voxels around each mesh
  double margin = 5.;                               ///< of the grid around both breasts, voxels
};

/// The common voxels on which the breasts of a pair are compared while they move, and the image
/// forces that follow from it. All functions are collective on the ranks of both breasts.
class Comparison {
public:
  /// On voxels of edge `level` mm around the unloaded breasts as they are now, or on those of
  /// `grid` if it has any. Keeps references to the pair and to what `compared` refers to.
  Comparison(const BreastPair& pair, const ComparedImages& compared, Compared by, double level,
             const image::VoxelGrid& grid = {});

  /// The name of what is measured.
  const std::string& name() const { return name_; }
  double level() const { return level_; }
  const std::shared_ptr<const similarity::Metric>& metric() const { return metric_; }
  const similarity::SimilarityDomain& domain() const { return domain_; }
  /// The loaded images that are compared, of the held breasts, smoothed for voxels of this size.
  const PerPosition<image::ScalarImage>& images() const { return images_; }

  /// Of the pair's present state.
  double value() const;
  /// As similarity::residuals_of(), on every rank.
  std::vector<float> residuals() const;
  /// Gives each breast its image forces, and returns the value.
  double set_image_forces(similarity::Variable variable) const;

private:
  similarity::Dissimilarity evaluate() const;

  const BreastPair& pair_;
  std::string name_;
  double level_;
  std::shared_ptr<const similarity::Metric> metric_;
  PerPosition<image::ScalarImage> images_;
  similarity::SimilarityDomain domain_;
};

} // namespace prosup::registration

#endif
