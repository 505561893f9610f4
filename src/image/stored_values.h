#ifndef PROSUP_SRC_IMAGE_STORED_VALUES_H
#define PROSUP_SRC_IMAGE_STORED_VALUES_H

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace prosup::image {

/// The types of numbers that files hold.
enum class NumberType {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

/// How the values of an image are stored in a file.
struct StoredValues {
  NumberType type = NumberType::uint8;
  bool swapped = false;      ///< in the byte order that this machine has not
  unsigned n_components = 1; ///< numbers at a voxel
  double slope = 1.;         ///< what is meant is  slope * number + intercept
  double intercept = 0.;

  std::size_t bytes_per_number() const;
  std::size_t bytes_per_voxel() const { return n_components * bytes_per_number(); }

  /// Between what neighbouring integers mean; 0 for other numbers, and for integers as they are.
  double step() const;

  /// Appends what `n` stored numbers mean.
  void append(const unsigned char* bytes, std::size_t n, std::vector<float>& values) const;
};

/// The product of sizes from a header, or the largest number if it is larger.
std::uintmax_t saturated_product(std::initializer_list<std::uintmax_t> factors);

} // namespace prosup::image

#endif
