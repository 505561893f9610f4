#include "prosup/similarity/mutual_information.h"

#include <deal.II/base/patterns.h>

#include <array>
#include <cmath>

#include "joint_histogram.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/filters.h"

namespace prosup::similarity {

namespace {

constexpr unsigned fewest_bins = 8, most_bins = 256;

/// Entropies of a joint histogram, and its surface M at the bins.
struct Information {
  double nmi = 1.;
  double joint_entropy = 0.;
  BinTable surface;

  explicit Information(const BinTable& p, unsigned n_bins) : surface(n_bins) {
    std::vector<double> marginal[2] = {std::vector<double>(n_bins), std::vector<double>(n_bins)};
    for (unsigned i = 0; i < n_bins; ++i)
      for (unsigned j = 0; j < n_bins; ++j) {
        marginal[0][i] += p(i, j);
        marginal[1][j] += p(i, j);
        joint_entropy -= p(i, j) * log(p(i, j));
      }
    double single_entropies = 0.;
    for (const std::vector<double>& m : marginal)
      for (const double p_i : m)
        single_entropies -= p_i * log(p_i);
    nmi = single_entropies / joint_entropy;
    for (unsigned i = 0; i < n_bins; ++i)
      for (unsigned j = 0; j < n_bins; ++j)
        surface(i, j) = nmi * log(p(i, j)) - log(marginal[0][i]) - log(marginal[1][j]);
  }

private:
  /// An empty bin has no part in anything.
  static double log(double p) { return p > 0. ? std::log(p) : 0.; }
};

/// Means of squared slopes over the voxels in each bin of the other image.
class Fisher {
public:
  explicit Fisher(unsigned n_bins) : sum_(n_bins), count_(n_bins) {}

  void add(unsigned other_bin, double slope) {
    sum_[other_bin] += slope * slope;
    count_[other_bin] += 1.;
  }

  double mean(unsigned other_bin) const { return sum_[other_bin] / count_[other_bin]; }

private:
  std::vector<double> sum_, count_;
};

} // namespace

NormalisedMutualInformation::NormalisedMutualInformation(unsigned n_bins) : n_bins_(n_bins) {
  if (n_bins < fewest_bins || n_bins > most_bins)
    throw Error(format("The joint histogram of nmi has %u bins, but must have %u to %u; change "
                       "'Similarity/nmi/Bins'.",
                       n_bins, fewest_bins, most_bins));
}

void NormalisedMutualInformation::declare_parameters(dealii::ParameterHandler& prm) {
  prm.enter_subsection(name());
  prm.add_parameter("Bins", n_bins_,
                    "Number of bins of the joint histogram, for each image. Units: none.",
                    dealii::Patterns::Integer(fewest_bins, most_bins));
  prm.leave_subsection();
}

double NormalisedMutualInformation::evaluate(const WarpedPair& pair,
                                             VoxelDerivatives& derivatives) const {
  const std::size_t n_voxels = pair.in_domain.size();
  derivatives.reset(n_voxels);
  const Bins bins(n_bins_, image::rescaled_range.low, image::rescaled_range.high);
  const auto for_each_voxel = [&](const auto& visit) {
    for (std::size_t v = 0; v < n_voxels; ++v)
      if (pair.in_domain[v])
        visit(v, pair.values.prone[v], pair.values.supine[v]);
  };

  std::size_t n_counted = 0;
  BinTable histogram(n_bins_);
  for_each_voxel([&](std::size_t, float p, float s) {
    histogram.add(bins.at(p), bins.at(s));
    ++n_counted;
  });
  if (n_counted == 0)
    return 0.;
  for (double& count : histogram.values())
    count /= static_cast<double>(n_counted);
  const Information information(histogram, n_bins_);

  const double volume = pair.grid.voxel_volume();
  const double factor = scale * volume / information.joint_entropy;
  PerPosition<Fisher> fisher{Fisher(n_bins_), Fisher(n_bins_)};
  for_each_voxel([&](std::size_t v, float p, float s) {
    const auto [by_p, by_s] = information.surface.gradient(bins.at(p), bins.at(s));
    fisher.prone.add(bins.nearest(s), by_p);
    fisher.supine.add(bins.nearest(p), by_s);
    derivatives.slope.prone[v] = static_cast<float>(-factor * by_p);
    derivatives.slope.supine[v] = static_cast<float>(-factor * by_s);
  });
  for_each_voxel([&](std::size_t v, float p, float s) {
    derivatives.curvature.prone[v] =
        static_cast<float>(factor * fisher.prone.mean(bins.nearest(s)));
    derivatives.curvature.supine[v] =
        static_cast<float>(factor * fisher.supine.mean(bins.nearest(p)));
  });
  return scale * volume * static_cast<double>(n_counted) * (2. - information.nmi);
}

} // namespace prosup::similarity
