#include "prosup/prepare/tissues.h"

#include <algorithm>
#include <cmath>

#include "breast_voxels.h"
#include "prosup/core/error.h"
#include "prosup/image/filters.h"

namespace prosup::prepare {

namespace {

constexpr unsigned n_rounds = 12;
constexpr unsigned rounds_per_field = 3;
constexpr float strong_coupling = 1.5f, weak_coupling = 0.5f; // beta
constexpr float darkest = -200.f, brightest_ct = 300.f;       // HU; beyond is no soft tissue
constexpr double field_width = 10.;                           // mm
constexpr double brightest = 1.3; // of what counts for the mean of gland: vessels are brighter
constexpr double smallest_share = 0.01, largest_share = 0.95; // of gland
constexpr double smallest_part = 200.;                        // mm^3 of gland

/// Expectation maximisation; q is the probability of gland.
class TissueMixture {
public:
  explicit TissueMixture(const TissueImage& image)
      : image_(image), voxels_(image.inner), field_(image.inner.grid, field_width),
        value_(voxels_.voxel.size()), gain_(value_.size(), 1.f), q_(value_.size(), 0.f) {
    if (value_.empty())
      throw Error("No fat and gland can be told apart because no voxel is inside of the breast; "
                  "check the side and the outlines.");
    for (std::size_t i = 0; i < value_.size(); ++i)
      value_[i] = image.is_ct
                      ? std::clamp(image.image.values[voxels_.voxel[i]], darkest, brightest_ct)
                      : image.image.values[voxels_.voxel[i]];
  }

  Tissues run() {
    start();
    for (unsigned round = 1; round <= n_rounds; ++round) {
      expect(strong_coupling);
      maximise();
      if (!image_.is_ct && round % rounds_per_field == 0 && round < n_rounds)
        fit_gain();
    }
    share_ = 0.5; // from here on the boundary lies midway between the tissues
    for (unsigned round = 0; round < 2; ++round)
      expect(weak_coupling);
    drop_small_parts();
    return result();
  }

private:
  /// Fat is in the upper or lower half of the intensities, gland at their other end.
  void start() {
    std::vector<float> sorted;
    for (std::size_t i = 0; i < value_.size(); i += 1 + value_.size() / 200000)
      sorted.push_back(value_[i]);
    std::sort(sorted.begin(), sorted.end());
    const auto quantile = [&](double share) {
      return double(sorted[std::size_t(share * double(sorted.size() - 1))]);
    };
    fat_ = quantile(image_.fat_is_bright ? 0.75 : 0.25);
    gland_ = quantile(image_.fat_is_bright ? 0.05 : 0.95);
    if (gland_ == fat_)
      gland_ = fat_ + (image_.fat_is_bright ? -1e-3 : 1e-3);
    deviation_ = 0.25 * std::abs(gland_ - fat_);
  }

  /// The fraction of gland that the intensity tells, at most 1: vessels and lesions are brighter
  /// than gland, and no less gland.
  double fraction(std::size_t i) const {
    return std::min((double(value_[i] / gain_[i]) - fat_) / (gland_ - fat_), 1.);
  }

  void expect(float coupling) {
    const double contrast = std::abs(gland_ - fat_) / deviation_;
    const double prior = std::log(share_ / (1. - share_));
    std::vector<float> next(q_.size());
    for (std::size_t i = 0; i < q_.size(); ++i) {
      float neighbours = 0.f;
      for (unsigned n = 0; n < 6; ++n) {
        const std::uint32_t neighbour = voxels_.neighbours[i][n];
        if (neighbour != BreastVoxels::none)
          neighbours += voxels_.weight[n] * (2.f * q_[neighbour] - 1.f);
      }
      // ln N(gland) - ln N(fat) of Gaussians with the same deviation
      const double data = contrast * contrast * (fraction(i) - 0.5);
      const auto odds = float(std::clamp(data + prior, -30., 30.)) + coupling * neighbours;
      next[i] = 1.f / (1.f + std::exp(-odds));
    }
    q_.swap(next);
  }

  void maximise() {
    double n_gland = 0., of_fat = 0., of_gland = 0.;
    for (std::size_t i = 0; i < q_.size(); ++i) {
      const double value = double(value_[i] / gain_[i]), q = double(q_[i]);
      const double share = (value - fat_) / (gland_ - fat_);
      n_gland += q;
      of_gland += q * (fat_ + std::min(share, brightest) * (gland_ - fat_));
      of_fat += (1. - q) * value;
    }
    const double n = double(q_.size());
    share_ = std::clamp(n_gland / n, smallest_share, largest_share);
    if (n_gland < 1e-6 * n || n_gland > (1. - 1e-6) * n)
      return;
    fat_ = of_fat / (n - n_gland);
    gland_ = of_gland / n_gland;
    double squares = 0.;
    for (std::size_t i = 0; i < q_.size(); ++i) {
      const double f = fraction(i), q = double(q_[i]);
      squares += q * (1. - f) * (1. - f) + (1. - q) * f * f;
    }
    deviation_ = std::max(std::sqrt(squares / n), 1e-3) * std::abs(gland_ - fat_);
  }

  /// What is left of the bias field, as a factor.
  void fit_gain() {
    std::vector<float> weight(q_.size()), ratio(q_.size());
    for (std::size_t i = 0; i < q_.size(); ++i) {
      weight[i] = 1.f - q_[i];
      ratio[i] = value_[i] / float(fat_);
    }
    field_.fit(voxels_, ratio, weight);
    field_.sample(voxels_, gain_);
    for (float& gain : gain_)
      gain = std::clamp(gain, 0.2f, 5.f);
  }

  /// Makes fat of gland that hangs together with none: vessels and noise.
  void drop_small_parts() {
    image::LabelImage gland(image_.inner.grid);
    for (std::size_t i = 0; i < q_.size(); ++i)
      gland.values[voxels_.voxel[i]] = q_[i] > 0.5f;
    gland = image::without_small_parts(gland, smallest_part);
    for (std::size_t i = 0; i < q_.size(); ++i)
      if (gland.values[voxels_.voxel[i]] == 0)
        q_[i] = std::min(q_[i], 0.5f);
  }

  bool touches_gland(std::size_t i) const {
    bool touches = q_[i] > 0.5f;
    for (const std::uint32_t neighbour : voxels_.neighbours[i])
      touches = touches || (neighbour != BreastVoxels::none && q_[neighbour] > 0.5f);
    return touches;
  }

  Tissues result() const {
    Tissues tissues;
    tissues.gland = image::LabelImage(image_.inner.grid);
    tissues.fraction = image::ScalarImage(image_.inner.grid);
    for (std::size_t i = 0; i < q_.size(); ++i) {
      tissues.gland.values[voxels_.voxel[i]] = q_[i] > 0.5f;
      if (touches_gland(i))
        tissues.fraction.values[voxels_.voxel[i]] = float(std::max(fraction(i), 0.));
    }
    tissues.fat = fat_;
    tissues.gland_intensity = gland_;
    tissues.deviation = deviation_;
    return tissues;
  }

  const TissueImage& image_;
  const BreastVoxels voxels_;
  SmoothField field_;
  std::vector<float> value_, gain_, q_;
  double fat_ = 0., gland_ = 1., deviation_ = 1., share_ = 0.2;
};

} // namespace

double Tissues::separation() const {
  return std::abs(gland_intensity - fat) / deviation;
}

Tissues find_tissues(const TissueImage& image) {
  return TissueMixture(image).run();
}

} // namespace prosup::prepare
