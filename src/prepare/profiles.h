#ifndef PROSUP_SRC_PREPARE_PROFILES_H
#define PROSUP_SRC_PREPARE_PROFILES_H

#include "map_filters.h"
#include "prosup/image/voxel_image.h"
#include "prosup/prepare/trunk.h"

namespace prosup::prepare {

/// What profiles are sampled from. Keeps references.
struct ProfileSource {
  const image::ScalarImage& image;
  const image::LabelImage& body;
  double air = 0.; ///< intensity of air, which keeps the logarithm of noise small
  bool is_ct = false;

  /// The scale on which tissues are compared: the logarithm of an MR intensity, so that a slow bias
  /// is a constant, or Hounsfield units between fat and muscle over 150.
  float scaled(float intensity) const;
};

/// Image profiles along the columns of a trunk grid, from inside to outside.
struct Profiles {
  TrunkGrid grid;
  ColumnMap start;           ///< radius of the first sample of each column, mm
  double step = 1.;          ///< between samples, mm
  std::size_t n_samples = 0; ///< in each column
  std::vector<float> u;      ///< scaled intensities, 0 outside of the image
  std::vector<char> known;   ///< whether the sample lies in the image
  std::vector<char> is_body; ///< and in the body

  std::size_t first_of(std::size_t row, std::size_t column) const {
    return (row * grid.n_columns + column) * n_samples;
  }
  double radius(std::size_t row, std::size_t column, double sample) const {
    return start(row, column) + sample * step;
  }
};

Profiles sample_profiles(const ProfileSource& source, const TrunkGrid& grid, const ColumnMap& start,
                         double step, std::size_t n_samples);

/// Sums over samples from `first` to before `end`, cut at both ends of the profile.
class RunningSum {
public:
  void clear() { sums_.assign(1, 0.); }
  void add(double value) { sums_.push_back(sums_.back() + value); }
  double operator()(long first, long end) const;

private:
  std::vector<double> sums_{0.};
};

} // namespace prosup::prepare

#endif
