#ifndef PROSUP_SRC_SIMILARITY_JOINT_HISTOGRAM_H
#define PROSUP_SRC_SIMILARITY_JOINT_HISTOGRAM_H

#include <algorithm>
#include <array>
#include <vector>

namespace prosup::similarity {

/// The cubic B-splines that an intensity touches: of four bins in a row.
struct Spline {
  unsigned first = 0;
  std::array<double, 4> value{}; ///< B_i, sum 1
  std::array<double, 4> slope{}; ///< dB_i/dx, sum 0; zero at and beyond the ends
};

/// Bins whose splines add to one everywhere on the range from low to high.
class Bins {
public:
  Bins(unsigned n, double low, double high)
      : n_(n), low_(low), per_unit_((n - 3) / (high - low)), end_(n - 3.) {}

  unsigned size() const { return n_; }

  /// The bin in the middle of those that an intensity touches.
  unsigned nearest(double x) const {
    return static_cast<unsigned>(std::clamp((x - low_) * per_unit_, 0., end_) + 1.5);
  }

  Spline at(double x) const {
    Spline spline;
    const double t = (x - low_) * per_unit_, inside = std::clamp(t, 0., end_);
    spline.first = std::min(static_cast<unsigned>(inside), n_ - 4);
    const double f = inside - spline.first, g = 1. - f;
    spline.value = {g * g * g / 6., (3. * f - 6.) * f * f / 6. + 4. / 6.,
                    (3. * g - 6.) * g * g / 6. + 4. / 6., f * f * f / 6.};
    if (t > 0. && t < end_)
      spline.slope = {-0.5 * g * g * per_unit_, (1.5 * f - 2.) * f * per_unit_,
                      -(1.5 * g - 2.) * g * per_unit_, 0.5 * f * f * per_unit_};
    return spline;
  }

private:
  unsigned n_;
  double low_, per_unit_, end_;
};

/// Values on pairs of bins, those of the second image running fastest.
class BinTable {
public:
  explicit BinTable(unsigned n_bins) : n_(n_bins), values_(n_bins * n_bins, 0.) {}

  double& operator()(unsigned i, unsigned j) { return values_[i * n_ + j]; }
  double operator()(unsigned i, unsigned j) const { return values_[i * n_ + j]; }
  std::vector<double>& values() { return values_; }

  void add(const Spline& a, const Spline& b) {
    for (unsigned i = 0; i < 4; ++i) {
      double* row = &values_[(a.first + i) * n_ + b.first];
      for (unsigned j = 0; j < 4; ++j)
        row[j] += a.value[i] * b.value[j];
    }
  }

  /// The derivatives by either intensity of the surface sum_ij B_i B_j t_ij.
  std::array<double, 2> gradient(const Spline& a, const Spline& b) const {
    std::array<double, 2> result{0., 0.};
    for (unsigned i = 0; i < 4; ++i) {
      const double* row = &values_[(a.first + i) * n_ + b.first];
      double value = 0., slope = 0.;
      for (unsigned j = 0; j < 4; ++j) {
        value += b.value[j] * row[j];
        slope += b.slope[j] * row[j];
      }
      result[0] += a.slope[i] * value;
      result[1] += a.value[i] * slope;
    }
    return result;
  }

private:
  unsigned n_;
  std::vector<double> values_;
};

} // namespace prosup::similarity

#endif
