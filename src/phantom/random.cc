#include "prosup/phantom/random.h"

#include <cmath>

namespace prosup::phantom {

namespace {

/// Spreads seeds that differ in one bit over all bits (splitmix64).
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

} // namespace

Random::Random(std::uint64_t seed, Stream stream, unsigned part)
    : engine_(mixed(mixed(seed) + static_cast<unsigned>(stream) + part)) {}

double Random::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2. * std::log(1. - uniform()));
  const double angle = 2. * M_PI * uniform();
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

double rician(double signal, double sigma, Random& random) {
  const double real = signal + sigma * random.normal();
  return std::hypot(real, sigma * random.normal());
}

} // namespace prosup::phantom
