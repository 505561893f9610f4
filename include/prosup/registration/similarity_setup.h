#ifndef PROSUP_REGISTRATION_SIMILARITY_SETUP_H
#define PROSUP_REGISTRATION_SIMILARITY_SETUP_H

#include <deal.II/base/parameter_acceptor.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "prosup/registration/body_pair.h"
#include "prosup/similarity/image_force.h"

namespace prosup::registration {

/// One value of the similarity along a registration.
struct SimilarityRecord {
  std::string stage;
  double level = 0.;        ///< voxel edge of the similarity grid, mm
  unsigned iteration = 0;
  double shear_modulus = 0.;///< Pa
  double force_weight = 0.; ///< kappa, Pa; 0 where no image force acts
  double value = 0.;
};

/// What is compared and how, section "Similarity": the metric, and the pair of
/// label images that say where an image holds air.
class SimilaritySetup : public dealii::ParameterAcceptor {
public:
  SimilaritySetup();

  /// @throws Error if there is no metric of the chosen name.
  void prepare(MPI_Comm world);

  const similarity::ImageForce& force() const { return *force_; }

  /// The domain with voxels of edge `level` mm around both unloaded meshes.
  similarity::SimilarityDomain domain(const BodyPair& pair,
                                      const std::array<image::LabelImage, 2>& labels,
                                      unsigned chest_label, double level) const;

  /// The loaded images of the held states, smoothed for `level` mm voxels.
  std::array<image::ScalarImage, 2> images(const BodyPair& pair, double level) const;

private:
  std::string metric_ = "ssd";
  unsigned n_layers_ = 2;
  double margin_ = 15.;
  std::shared_ptr<const similarity::ImageForce> force_;
};

} // namespace prosup::registration

#endif
