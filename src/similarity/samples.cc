#include "prosup/similarity/samples.h"

namespace prosup::similarity {

using dealii::Tensor;

namespace {

bool shows_tissue(float cover) {
  return cover == cover::tissue || cover == cover::near_tissue;
}

bool counts(float prone, float supine, bool no_air) {
  if (prone == cover::excluded || supine == cover::excluded)
    return false;
  if (!shows_tissue(prone) && !shows_tissue(supine))
    return false;
  const bool both = shows_tissue(prone) && shows_tissue(supine);
  const bool any_in_mesh = prone == cover::tissue || supine == cover::tissue;
  return !no_air || (both && any_in_mesh);
}

double residual_variance(const VoxelDerivatives& derivatives, double voxel_volume) {
  double slopes = 0., curvatures = 0.;
  for (const Position position : both_positions) {
    for (const double slope : derivatives.slope[position])
      slopes += slope * slope;
    for (const double curvature : derivatives.curvature[position])
      curvatures += curvature;
  }
  return curvatures > 0. ? slopes / curvatures / voxel_volume : 0.;
}

} // namespace

void Samples::reserve(std::size_t n) {
  voxels.reserve(n);
  values.reserve(n);
  covers.reserve(n);
  gradients.reserve(n);
}

void Samples::add(std::uint32_t voxel, float value, float cover, const Tensor<1, 3>& gradient) {
  voxels.push_back(voxel);
  values.push_back(value);
  covers.push_back(cover);
  gradients.emplace_back(gradient);
}

WarpedPair combine(const SimilarityDomain& domain, const PerPosition<const Samples*>& samples,
                   MPI_Comm communicator) {
  // Each voxel of a position belongs to one rank, so that sums put the parts together.
  const std::size_t n = domain.grid.n_voxels();
  WarpedPair pair{domain.grid, {}, std::vector<std::uint8_t>(n, 0)};
  PerPosition<std::vector<float>> covers;
  for (const Position position : both_positions) {
    std::vector<float>& values = pair.values[position];
    values.assign(n, 0.f);
    covers[position].assign(n, 0.f);
    if (const Samples* sampled = samples[position])
      for (std::size_t i = 0; i < sampled->voxels.size(); ++i) {
        values[sampled->voxels[i]] = sampled->values[i];
        covers[position][sampled->voxels[i]] = sampled->covers[i];
      }
    for (std::vector<float>* part : {&values, &covers[position]})
      MPI_Allreduce(MPI_IN_PLACE, part->data(), static_cast<int>(n), MPI_FLOAT, MPI_SUM,
                    communicator);
    for (std::size_t v = 0; v < n; ++v)
      if (covers[position][v] == 0.f)
        values[v] = domain.air[position];
  }
  for (std::size_t v = 0; v < n; ++v)
    pair.in_domain[v] =
        counts(covers.prone[v], covers.supine[v], !domain.no_air.empty() && domain.no_air[v]);
  return pair;
}

Dissimilarity evaluate(const Metric& metric, const SimilarityDomain& domain,
                       const PerPosition<const Samples*>& samples, MPI_Comm communicator) {
  Dissimilarity result;
  result.value = metric.evaluate(combine(domain, samples, communicator), result.derivatives);
  result.residual_variance = residual_variance(result.derivatives, domain.grid.voxel_volume());
  return result;
}

} // namespace prosup::similarity
