#ifndef PROSUP_PHANTOM_RANDOM_H
#define PROSUP_PHANTOM_RANDOM_H

#include <cstdint>
#include <random>

namespace prosup::phantom {

/// What random numbers are drawn for. Each purpose has a stream of its own, so
/// that one can change without the others.
enum class Stream : unsigned {
  gland_shape,
  gland_detail,
  fat_texture,
  septa,
  muscle,
  landmarks,
  noise, ///< and the next ones, one for each state
  bias = 16,
  jitter = 32 ///< three for each state
};

/// Random numbers that are the same everywhere: the engine is that of the
/// standard library, whose distributions are not the same everywhere.
class Random {
public:
  Random(std::uint64_t seed, Stream stream, unsigned part = 0);

  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Of mean 0 and standard deviation 1 (Box and Muller).
  double normal();

private:
  std::mt19937_64 engine_;
  double spare_ = 0.;
  bool has_spare_ = false;
};

/// Magnitude of a complex signal with Gaussian noise of standard deviation
/// `sigma` in both channels: the noise of MR images.
double rician(double signal, double sigma, Random& random);

} // namespace prosup::phantom

#endif
