#include "posterior.h"

#include "prosup/mechanics/static/random_forces.h"

namespace prosup::registration {

using namespace dealii;
using mechanics::NodeVector;

namespace {

constexpr double linear_tolerance = 1e-2; // far below the error of the sampling

} // namespace

std::vector<NodeCovariance> sampled_inverse(const PosteriorBody& body,
                                            const std::vector<mechanics::CellStiffness>& images,
                                            double factor, unsigned n_samples) {
  const mechanics::ElasticMetric metric(body.supports, body.material, body.unloaded);
  const std::vector<NodeVector> forces = mechanics::random_forces(
      body.supports, body.material, body.unloaded, images, factor, n_samples);
  std::vector<NodeCovariance> inverse(body.supports.body().n_owned_nodes());
  NodeVector displacement;
  for (const NodeVector& force : forces) {
    metric.solve(images, factor, force, linear_tolerance, displacement);
    for (unsigned node = 0; node < inverse.size(); ++node) {
      const Tensor<1, 3> u = mechanics::node_value(displacement, node);
      inverse[node] += symmetrize(outer_product(u, u)) / double(n_samples);
    }
  }
  return inverse;
}

} // namespace prosup::registration
