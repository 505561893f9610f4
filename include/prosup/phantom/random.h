#ifndef PROSUP_PHANTOM_RANDOM_H
#define PROSUP_PHANTOM_RANDOM_H

#include <cstdint>
#include <random>

namespace prosup::phantom {

/// Purposes of random numbers. Each has a stream of its own, so that changes to one do not
/// affect the others.
enum class Stream : unsigned {
  gland_shape,
  gland_detail,
  fat_texture,
  septa,
  muscle,
  landmarks,
  noise, ///< and the following ones, one for each image
  bias = 16,
  jitter = 32 ///< three for each label image
};

/// Random numbers that are the same on all systems. The engine is that of the standard library;
/// its distributions are not used, since they differ between systems.
class Random {
public:
  Random(std::uint64_t seed, Stream stream, unsigned part = 0);

  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Normally distributed, with mean 0 and standard deviation 1 (Box and Muller).
  double normal();

private:
  std::mt19937_64 engine_;
  double spare_ = 0.;
  bool has_spare_ = false;
};

/// Magnitude of a complex signal with Gaussian noise of standard deviation `sigma` in both
/// channels, as in MR images.
double rician(double signal, double sigma, Random& random);

} // namespace prosup::phantom

#endif
