#include "prosup/registration/agreement.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include "outlines.h"
#include "prosup/core/quantile.h"
#include "prosup/image/filters.h"
#include "prosup/similarity/local_correlation.h"
#include "prosup/similarity/mutual_information.h"

namespace prosup::registration {

using image::LabelImage;
using image::ScalarImage;
using similarity::Samples;
using similarity::SimilarityDomain;

namespace {

// Point samples on this grid: volumes and mean distances are known far better than to a voxel.
constexpr double edge = 3.;   // mm
constexpr double margin = 9.; // mm, of the grid around both breasts

/// 1 in the gland, 0 elsewhere.
ScalarImage gland_image(const LabelImage& labels, unsigned gland_label) {
  ScalarImage gland(labels.grid);
  std::transform(labels.values.begin(), labels.values.end(), gland.values.begin(),
                 [&](unsigned label) { return label == gland_label && label != 0 ? 1.f : 0.f; });
  return gland;
}

SimilarityDomain domain_of(const BreastPair& pair, const ComparedImages& compared) {
  similarity::Box box;
  pair.for_each([&](Position, Breast& breast) { box.include(breast.unloaded_box()); });
  return similarity::similarity_domain(
      similarity::common_grid(box, edge, margin, pair.ranks().world()), compared.scene, 0);
}

/// Both unloaded breasts on the voxels of one grid, on all ranks.
struct UnloadedVoxels {
  image::VoxelGrid grid;
  std::vector<bool> counts;           // is shown by both images
  PerPosition<LabelImage> all, shown; // masks of the breasts, and of their part that counts
  PerPosition<std::vector<float>> gland, intensity;

  UnloadedVoxels(const BreastPair& pair, const ComparedImages& compared, bool with_intensities) {
    const SimilarityDomain domain = domain_of(pair, compared);
    grid = domain.grid;
    const std::size_t n = grid.n_voxels();
    PerPosition<std::vector<float>> covers;
    for (const Position position : both_positions)
      covers[position] = gland[position] = intensity[position] = std::vector<float>(n, 0.f);
    pair.for_each([&](Position position, Breast& breast) {
      const Samples& tissues = breast.sample(
          domain, gland_image(compared.scene.labels[position], compared.scene.gland_label));
      for (std::size_t i = 0; i < tissues.voxels.size(); ++i) {
        covers[position][tissues.voxels[i]] = tissues.covers[i];
        gland[position][tissues.voxels[i]] = tissues.values[i];
      }
      if (!with_intensities)
        return;
      const Samples& samples =
          breast.sample(domain, image::gaussian_smooth(compared.images[position], 0.5 * edge));
      for (std::size_t i = 0; i < samples.voxels.size(); ++i)
        intensity[position][samples.voxels[i]] = samples.values[i];
    });
    for (const Position position : both_positions) {
      // Each voxel of a position belongs to one rank.
      for (auto* part : {&covers[position], &gland[position], &intensity[position]})
        MPI_Allreduce(MPI_IN_PLACE, part->data(), static_cast<int>(n), MPI_FLOAT, MPI_SUM,
                      pair.ranks().world());
      all[position] = shown[position] = LabelImage(grid);
    }
    counts.assign(n, false);
    for (std::size_t v = 0; v < n; ++v) {
      counts[v] = !domain.no_air[v];
      for (const Position position : both_positions) {
        all[position].values[v] = covers[position][v] == similarity::cover::tissue;
        shown[position].values[v] = counts[v] && all[position].values[v] != 0;
      }
    }
  }

  bool both(std::size_t v) const {
    return shown.prone.values[v] != 0 && shown.supine.values[v] != 0;
  }
};

double count(const LabelImage& mask) {
  return static_cast<double>(std::count(mask.values.begin(), mask.values.end(), 1));
}

double ratio(double part, double whole) {
  return whole > 0. ? part / whole : 0.;
}

void measure_overlap(const UnloadedVoxels& voxels, Agreement& result) {
  const double prone = count(voxels.shown.prone), supine = count(voxels.shown.supine);
  double common = 0., gland_common = 0., gland = 0.;
  for (std::size_t v = 0; v < voxels.counts.size(); ++v) {
    const bool in_prone = voxels.shown.prone.values[v] != 0 && voxels.gland.prone[v] > 0.5f,
               in_supine = voxels.shown.supine.values[v] != 0 && voxels.gland.supine[v] > 0.5f;
    common += voxels.both(v);
    gland_common += in_prone && in_supine;
    gland += in_prone + in_supine;
  }
  result.compared_share =
      std::min(ratio(prone, count(voxels.all.prone)), ratio(supine, count(voxels.all.supine)));
  result.volume_ratio = ratio(std::max(prone, supine), std::min(prone, supine));
  result.breast_dice = ratio(2. * common, prone + supine);
  result.gland_dice = gland > 0. ? 2. * gland_common / gland : 1.;
}

void measure_outlines(const UnloadedVoxels& voxels, Agreement& result) {
  PerPosition<ScalarImage> distance;
  for (const Position position : both_positions)
    distance[position] = distance_to(voxels.all[position]);
  if (distance.prone.values.empty() || distance.supine.values.empty())
    return;
  const auto apart = [&](std::size_t v) {
    return std::abs(distance.prone.values[v] - distance.supine.values[v]);
  };
  std::vector<double> distances;
  PerPosition<double> n_outside;
  for_each_neighbours(voxels.grid, [&](std::size_t v, std::size_t w) {
    if (voxels.counts[v] && voxels.counts[w])
      for (const Position position : both_positions)
        if (voxels.all[position].values[v] != voxels.all[position].values[w])
          distances.push_back(0.5 * (apart(v) + apart(w)));
  });
  for (std::size_t v = 0; v < voxels.counts.size(); ++v)
    for (const Position position : both_positions)
      n_outside[position] += voxels.shown[position].values[v] != 0 &&
                             distance[other(position)].values[v] > far_outside;
  for (const Position position : both_positions)
    result.outside_share =
        std::max(result.outside_share, ratio(n_outside[position], count(voxels.shown[position])));
  for (const double d : distances)
    result.skin_distance += d / static_cast<double>(distances.size());
  result.skin_p95 = quantile(std::move(distances), 0.95);
}

double pearson(const UnloadedVoxels& voxels) {
  double n = 0., p = 0., s = 0., pp = 0., ss = 0., ps = 0.;
  for (std::size_t v = 0; v < voxels.counts.size(); ++v) {
    if (!voxels.both(v))
      continue;
    const double a = voxels.intensity.prone[v], b = voxels.intensity.supine[v];
    n += 1.;
    p += a;
    s += b;
    pp += a * a;
    ss += b * b;
    ps += a * b;
  }
  const double variances = (n * pp - p * p) * (n * ss - s * s);
  return variances > 0. ? (n * ps - p * s) / std::sqrt(variances) : 0.;
}

void measure_intensities(const UnloadedVoxels& voxels, Agreement& result) {
  similarity::WarpedPair pair{voxels.grid, voxels.intensity, {}};
  pair.in_domain.resize(voxels.counts.size());
  double volume = 0.;
  for (std::size_t v = 0; v < pair.in_domain.size(); ++v) {
    pair.in_domain[v] = voxels.both(v);
    volume += voxels.both(v) * voxels.grid.voxel_volume();
  }
  Agreement::Intensities& intensities = result.intensities.emplace();
  if (!(volume > 0.))
    return;
  intensities.correlation = pearson(voxels);
  using similarity::LocalCorrelation;
  using similarity::NormalisedMutualInformation;
  similarity::VoxelDerivatives unused;
  intensities.local_correlation =
      1. - LocalCorrelation().evaluate(pair, unused) / (0.5 * LocalCorrelation::scale * volume);
  intensities.mutual_information = 1. - NormalisedMutualInformation().evaluate(pair, unused) /
                                            (NormalisedMutualInformation::scale * volume);
}

} // namespace

Agreement measure_agreement(const BreastPair& pair, const ComparedImages& compared,
                            bool with_intensities) {
  const UnloadedVoxels voxels(pair, compared, with_intensities);
  Agreement result;
  measure_overlap(voxels, result);
  measure_outlines(voxels, result);
  if (with_intensities)
    measure_intensities(voxels, result);
  return result;
}

} // namespace prosup::registration
