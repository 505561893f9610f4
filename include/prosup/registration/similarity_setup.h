#ifndef PROSUP_REGISTRATION_SIMILARITY_SETUP_H
#define PROSUP_REGISTRATION_SIMILARITY_SETUP_H

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "prosup/registration/body_pair.h"
#include "prosup/similarity/domain.h"
#include "prosup/similarity/image_force.h"
#include "prosup/similarity/similarity_parameters.h"

namespace prosup::registration {

/// A state along a registration.
struct SimilarityRecord {
  std::string stage;
  double level = 0.; ///< voxel edge of the similarity grid, mm
  unsigned iteration = 0;
  double force_weight = 0.; ///< kappa, Pa; 0 where no image force acts
  double value = 0.;        ///< of the metric
};

/// Told of each state that a registration goes on from, when the pair has it, on
/// all ranks.
using Observer = std::function<void(const SimilarityRecord&)>;

/// What is compared on one level.
struct Comparison {
  std::string metric;
  similarity::ImageForce force;
  similarity::SimilarityDomain domain;
  std::array<image::ScalarImage, 2> images; ///< loaded, of the states that are held
};

/// Makes what the similarity of a pair is measured on.
class SimilaritySetup {
public:
  /// @throws Error if there is no metric of the chosen name.
  SimilaritySetup(const similarity::SimilarityParameters& parameters, MPI_Comm world);

  const similarity::Metric& metric() const { return *metric_; }
  const similarity::ImageForce& force() const { return force_; }

  /// The domain with voxels of edge `level` mm around both unloaded meshes.
  similarity::SimilarityDomain domain(const BodyPair& pair, const similarity::Scene& scene,
                                      double level) const;

  /// The loaded images of the held states, smoothed for `level` mm voxels.
  std::array<image::ScalarImage, 2> images(const BodyPair& pair, double level) const;

  /// The images and the chosen metric.
  Comparison of_images(const BodyPair& pair, const similarity::Scene& scene, double level) const;

  /// The tissues as labelled, air 0, fat 1/2 and gland 1, and the sum of squared differences:
  /// what all images have in common, whatever their contrast, and smooth however far
  /// apart the bodies are.
  Comparison of_tissues(const BodyPair& pair, const similarity::Scene& scene, double level) const;

private:
  MPI_Comm world_;
  const similarity::SimilarityParameters& parameters_;
  const std::shared_ptr<const similarity::Metric> metric_;
  const similarity::ImageForce force_;
};

} // namespace prosup::registration

#endif
