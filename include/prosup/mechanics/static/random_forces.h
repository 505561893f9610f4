#ifndef PROSUP_MECHANICS_RANDOM_FORCES_H
#define PROSUP_MECHANICS_RANDOM_FORCES_H

#include <vector>

#include "prosup/mechanics/static/elastic_metric.h"

namespace prosup::mechanics {

/// `n` random nodal forces of mean 0, independent of each other, whose covariance is the stiffness
/// K + factor H of ElasticMetric, before its supports project it. Then (K + factor H)^-1 force has
/// the covariance (K + factor H)^-1. Each cell adds L s, where L L^T is its part of the stiffness
/// and s are random signs; so does each spring. The signs follow from where cells and nodes lie
/// and from the number of the force, so that they are the same on any number of ranks.
/// `unloaded` has ghosts, mm; forces have owned nodes. Collective on the communicator of the body.
std::vector<NodeVector> random_forces(const Supports& supports, const Material& material,
                                      const NodeVector& unloaded,
                                      const std::vector<CellStiffness>& added, double factor,
                                      unsigned n);

} // namespace prosup::mechanics

#endif
