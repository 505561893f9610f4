#ifndef PROSUP_SRC_REGISTRATION_POSTERIOR_H
#define PROSUP_SRC_REGISTRATION_POSTERIOR_H

#include <vector>

#include "prosup/mechanics/static/elastic_metric.h"

namespace prosup::registration {

/// A covariance of the position of a node.
using NodeCovariance = dealii::SymmetricTensor<2, 3>;

/// A body at X whose covariances are asked for. Refers to objects that have to live as long.
struct PosteriorBody {
  const mechanics::Supports& supports;
  const mechanics::Material& material;
  const mechanics::NodeVector& unloaded; ///< X with ghosts, mm
};

/// The 3 x 3 blocks of (K + factor H)^-1 at owned nodes, mm/(g/s^2), from `n_samples` random
/// displacements with this covariance: K + factor H is solved for random forces that have it as
/// theirs (mechanics::random_forces()). A variance is off by a part of (2/n)^1/2; the sum of the
/// three by about half of this. H is the stiffness of the images, or nothing. Collective on the
/// communicator of the body.
std::vector<NodeCovariance> sampled_inverse(const PosteriorBody& body,
                                            const std::vector<mechanics::CellStiffness>& images,
                                            double factor, unsigned n_samples);

} // namespace prosup::registration

#endif
