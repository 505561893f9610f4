#include "stored_values.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace prosup::image {

namespace {

/// Calls `visit` with a number of the type.
template <typename Visitor>
auto with_type(NumberType type, const Visitor& visit) {
  switch (type) {
  case NumberType::int8:
    return visit(std::int8_t());
  case NumberType::uint8:
    return visit(std::uint8_t());
  case NumberType::int16:
    return visit(std::int16_t());
  case NumberType::uint16:
    return visit(std::uint16_t());
  case NumberType::int32:
    return visit(std::int32_t());
  case NumberType::uint32:
    return visit(std::uint32_t());
  case NumberType::int64:
    return visit(std::int64_t());
  case NumberType::uint64:
    return visit(std::uint64_t());
  case NumberType::float32:
    return visit(float());
  default:
    return visit(double());
  }
}

template <typename Number>
Number number_at(const unsigned char* bytes, bool swapped) {
  unsigned char ordered[sizeof(Number)];
  std::memcpy(ordered, bytes, sizeof(Number));
  if (swapped)
    std::reverse(ordered, ordered + sizeof(Number));
  Number number;
  std::memcpy(&number, ordered, sizeof(Number));
  return number;
}

/// What is beyond the range of float becomes infinite, which no image may be.
float as_float(double value) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::abs(value) <= double(std::numeric_limits<float>::max()) || std::isnan(value))
    return static_cast<float>(value);
  return static_cast<float>(value > 0. ? infinity : -infinity);
}

} // namespace

std::size_t StoredValues::bytes_per_number() const {
  return with_type(type, [](auto number) { return sizeof(number); });
}

double StoredValues::step() const {
  const bool is_integer = type != NumberType::float32 && type != NumberType::float64;
  return is_integer && slope != 1. ? std::abs(slope) : 0.;
}

void StoredValues::append(const unsigned char* bytes, std::size_t n,
                          std::vector<float>& values) const {
  const bool is_scaled = slope != 1. || intercept != 0.;
  const std::size_t n_before = values.size();
  values.resize(n_before + n);
  float* next = values.data() + n_before;
  with_type(type, [&](auto kind) {
    using Number = decltype(kind);
    for (std::size_t i = 0; i < n; ++i) {
      const auto number = double(number_at<Number>(bytes + i * sizeof(Number), swapped));
      next[i] = as_float(is_scaled ? slope * number + intercept : number);
    }
  });
}

std::uintmax_t saturated_product(std::initializer_list<std::uintmax_t> factors) {
  std::uintmax_t product = 1;
  for (const std::uintmax_t factor : factors)
    if (__builtin_mul_overflow(product, factor, &product))
      product = factor == 0 ? 0 : std::numeric_limits<std::uintmax_t>::max();
  return product;
}

} // namespace prosup::image
