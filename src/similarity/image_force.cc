#include "prosup/similarity/image_force.h"

#include <utility>

namespace prosup::similarity {

namespace {

PerPosition<ElementSamples> sampled(const SimilarityDomain& domain,
                                    const PerPosition<ImagedBody>& bodies) {
  const auto of = [&](Position position) {
    return ElementSamples(domain, bodies[position],
                          domain.excluded == nullptr ? nullptr : &(*domain.excluded)[position]);
  };
  return {of(Position::prone), of(Position::supine)};
}

PerPosition<const Samples*> pointers(const PerPosition<ElementSamples>& samples) {
  return {&samples.prone.samples(), &samples.supine.samples()};
}

} // namespace

ImageForce::ImageForce(std::shared_ptr<const Metric> metric, MPI_Comm communicator)
    : metric_(std::move(metric)), communicator_(communicator) {}

SimilarityResult ImageForce::evaluate(const SimilarityDomain& domain,
                                      const PerPosition<ImagedBody>& bodies, Variable variable,
                                      bool with_stiffness) const {
  PerPosition<ElementSamples> samples = sampled(domain, bodies);
  const Dissimilarity found =
      similarity::evaluate(*metric_, domain, pointers(samples), communicator_);
  SimilarityResult result;
  result.value = found.value;
  result.residual_variance = found.residual_variance;
  for (const Position position : both_positions) {
    samples[position].derive_by(variable);
    result.forces[position] = samples[position].forces(found.derivatives.slope[position]);
    if (with_stiffness)
      result.stiffness[position] =
          samples[position].stiffness(found.derivatives.curvature[position]);
  }
  return result;
}

double ImageForce::value(const SimilarityDomain& domain,
                         const PerPosition<ImagedBody>& bodies) const {
  VoxelDerivatives derivatives;
  return metric_->evaluate(warp(domain, bodies), derivatives);
}

std::vector<float> ImageForce::residuals(const SimilarityDomain& domain,
                                         const PerPosition<ImagedBody>& bodies) const {
  VoxelDerivatives derivatives;
  metric_->evaluate(warp(domain, bodies), derivatives);
  return residuals_of(std::move(derivatives));
}

WarpedPair ImageForce::warp(const SimilarityDomain& domain,
                            const PerPosition<ImagedBody>& bodies) const {
  return combine(domain, pointers(sampled(domain, bodies)), communicator_);
}

} // namespace prosup::similarity
