// Lanes of several elements as GCC/Clang vectors, for element_kernel_loops.h.
// Included once per instruction set, inside its namespace.

#define PROSUP_INLINE inline __attribute__((always_inline))

typedef double Double4 __attribute__((vector_size(32)));
typedef double Double8 __attribute__((vector_size(64)));
typedef float Float4 __attribute__((vector_size(16)));
typedef float Float8 __attribute__((vector_size(32)));

PROSUP_INLINE const Double4& node_at(const double* field, std::uint32_t node) {
  return *reinterpret_cast<const Double4*>(field + node_stride * static_cast<std::size_t>(node));
}
PROSUP_INLINE Double4& node_at(double* field, std::uint32_t node) {
  return *reinterpret_cast<Double4*>(field + node_stride * static_cast<std::size_t>(node));
}

// Rows become columns.
PROSUP_INLINE void transpose(Double4 (&r)[4]) {
  const Double4 t0 = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6);
  const Double4 t1 = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
  const Double4 t2 = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6);
  const Double4 t3 = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
  r[0] = __builtin_shufflevector(t0, t2, 0, 1, 4, 5);
  r[1] = __builtin_shufflevector(t1, t3, 0, 1, 4, 5);
  r[2] = __builtin_shufflevector(t0, t2, 2, 3, 6, 7);
  r[3] = __builtin_shufflevector(t1, t3, 2, 3, 6, 7);
}

// The same in both halves.
PROSUP_INLINE void transpose(Float8 (&r)[4]) {
  const Float8 t0 = __builtin_shufflevector(r[0], r[1], 0, 8, 1, 9, 4, 12, 5, 13);
  const Float8 t1 = __builtin_shufflevector(r[0], r[1], 2, 10, 3, 11, 6, 14, 7, 15);
  const Float8 t2 = __builtin_shufflevector(r[2], r[3], 0, 8, 1, 9, 4, 12, 5, 13);
  const Float8 t3 = __builtin_shufflevector(r[2], r[3], 2, 10, 3, 11, 6, 14, 7, 15);
  r[0] = __builtin_shufflevector(t0, t2, 0, 1, 8, 9, 4, 5, 12, 13);
  r[1] = __builtin_shufflevector(t0, t2, 2, 3, 10, 11, 6, 7, 14, 15);
  r[2] = __builtin_shufflevector(t1, t3, 0, 1, 8, 9, 4, 5, 12, 13);
  r[3] = __builtin_shufflevector(t1, t3, 2, 3, 10, 11, 6, 7, 14, 15);
}

// A group of lanes: Value holds `width` of them. gather() takes the four
// doubles of one node per lane less those of another, the subtraction in
// double precision always; scatter() adds three components to one node per
// lane.
struct FourDoubles {
  using Real = double;
  using Value = Double4;
  static constexpr int width = 4;

  PROSUP_INLINE static void gather(const double* field, const std::uint32_t* node,
                                   const std::uint32_t* origin, Value (&v)[4]) {
    for (int l = 0; l < 4; ++l)
      v[l] = node_at(field, node[l]) - node_at(field, origin[l]);
    transpose(v);
  }
  PROSUP_INLINE static void scatter(double* field, const std::uint32_t* node, Value x, Value y,
                                    Value z) {
    Value v[4] = {x, y, z, Value{}};
    transpose(v);
    for (int l = 0; l < 4; ++l)
      node_at(field, node[l]) += v[l];
  }
  // x = m 2^e with m in [sqrt(1/2), sqrt(2)); see logarithm().
  PROSUP_INLINE static void split(Value x, Value& m, Value& e) {
    typedef std::uint64_t Bits __attribute__((vector_size(32)));
    constexpr std::uint64_t sqrt_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
    constexpr std::uint64_t mantissa = 0x000fffffffffffff, two_52 = 0x4330000000000000;
    Bits bits = reinterpret_cast<Bits>(x) + (one - sqrt_half);
    // x is positive, so that the shifted bits are the exponent alone.
    e = reinterpret_cast<Value>((bits >> 52) | two_52) - (4503599627370496. + 1023.);
    m = reinterpret_cast<Value>((bits & mantissa) + sqrt_half);
  }
};

struct EightDoubles {
  using Real = double;
  using Value = Double8;
  static constexpr int width = 8;

  PROSUP_INLINE static Value join(Double4 low, Double4 high) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
  PROSUP_INLINE static void gather(const double* field, const std::uint32_t* node,
                                   const std::uint32_t* origin, Value (&v)[4]) {
    Double4 low[4], high[4];
    FourDoubles::gather(field, node, origin, low);
    FourDoubles::gather(field, node + 4, origin + 4, high);
    for (int c = 0; c < 4; ++c)
      v[c] = join(low[c], high[c]);
  }
  PROSUP_INLINE static void scatter(double* field, const std::uint32_t* node, Value x, Value y,
                                    Value z) {
    FourDoubles::scatter(field, node, __builtin_shufflevector(x, x, 0, 1, 2, 3),
                         __builtin_shufflevector(y, y, 0, 1, 2, 3),
                         __builtin_shufflevector(z, z, 0, 1, 2, 3));
    FourDoubles::scatter(field, node + 4, __builtin_shufflevector(x, x, 4, 5, 6, 7),
                         __builtin_shufflevector(y, y, 4, 5, 6, 7),
                         __builtin_shufflevector(z, z, 4, 5, 6, 7));
  }
  PROSUP_INLINE static void split(Value x, Value& m, Value& e) {
    typedef std::uint64_t Bits __attribute__((vector_size(64)));
    constexpr std::uint64_t sqrt_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
    constexpr std::uint64_t mantissa = 0x000fffffffffffff, two_52 = 0x4330000000000000;
    Bits bits = reinterpret_cast<Bits>(x) + (one - sqrt_half);
    e = reinterpret_cast<Value>((bits >> 52) | two_52) - (4503599627370496. + 1023.);
    m = reinterpret_cast<Value>((bits & mantissa) + sqrt_half);
  }
};

struct EightFloats {
  using Real = float;
  using Value = Float8;
  static constexpr int width = 8;

  PROSUP_INLINE static Value join(Float4 low, Float4 high) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
  PROSUP_INLINE static void gather(const double* field, const std::uint32_t* node,
                                   const std::uint32_t* origin, Value (&v)[4]) {
    Float4 half[8];
    for (int l = 0; l < 8; ++l)
      half[l] =
          __builtin_convertvector(node_at(field, node[l]) - node_at(field, origin[l]), Float4);
    for (int l = 0; l < 4; ++l)
      v[l] = join(half[l], half[l + 4]);
    transpose(v);
  }
  PROSUP_INLINE static void scatter(double* field, const std::uint32_t* node, Value x, Value y,
                                    Value z) {
    Value v[4] = {x, y, z, Value{}};
    transpose(v);
    for (int l = 0; l < 4; ++l) {
      node_at(field, node[l]) +=
          __builtin_convertvector(__builtin_shufflevector(v[l], v[l], 0, 1, 2, 3), Double4);
      node_at(field, node[l + 4]) +=
          __builtin_convertvector(__builtin_shufflevector(v[l], v[l], 4, 5, 6, 7), Double4);
    }
  }
  PROSUP_INLINE static void split(Value x, Value& m, Value& e) {
    typedef std::int32_t Bits __attribute__((vector_size(32)));
    // Lanes that are no numbers would overflow.
    typedef std::uint32_t UnsignedBits __attribute__((vector_size(32)));
    constexpr std::int32_t sqrt_half = 0x3f3504f3, one = 0x3f800000, mantissa = 0x007fffff;
    Bits bits = reinterpret_cast<Bits>(reinterpret_cast<UnsignedBits>(x) +
                                       static_cast<std::uint32_t>(one - sqrt_half));
    e = __builtin_convertvector((bits >> 23) - 127, Value);
    m = reinterpret_cast<Value>((bits & mantissa) + sqrt_half);
  }
};

template <typename Group>
PROSUP_INLINE typename Group::Value load(const typename Group::Real* lanes) {
  return *reinterpret_cast<const typename Group::Value*>(lanes);
}
template <typename Group>
PROSUP_INLINE void store(typename Group::Real* lanes, typename Group::Value value) {
  *reinterpret_cast<typename Group::Value*>(lanes) = value;
}
template <typename Group>
PROSUP_INLINE typename Group::Value all(double value) {
  return typename Group::Value{} + static_cast<typename Group::Real>(value);
}

template <typename Group>
PROSUP_INLINE double smallest_lane(typename Group::Value v) {
  double smallest = v[0];
  for (int l = 1; l < Group::width; ++l)
    smallest = v[l] < smallest ? v[l] : smallest;
  return smallest;
}

// Natural logarithm of positive lanes to rounding, without a call, so that the
// loop stays vectorised: ln m = 2 artanh((m - 1)/(m + 1)) as a series.
template <typename Group>
PROSUP_INLINE typename Group::Value logarithm(typename Group::Value x) {
  using Value = typename Group::Value;
  using Real = typename Group::Real;
  Value m, exponent;
  Group::split(x, m, exponent);
  const Value s = (m - Real(1)) / (m + Real(1)), s2 = s * s;
  Value series;
  if constexpr (sizeof(Real) == sizeof(double)) {
    series = s2 * Real(1. / 19) + Real(1. / 17);
    series = s2 * series + Real(1. / 15);
    series = s2 * series + Real(1. / 13);
    series = s2 * series + Real(1. / 11);
    series = s2 * series + Real(1. / 9);
  } else {
    series = all<Group>(1. / 9);
  }
  series = s2 * series + Real(1. / 7);
  series = s2 * series + Real(1. / 5);
  series = s2 * series + Real(1. / 3);
  series = s2 * series + Real(1);
  return exponent * Real(0.6931471805599453) + Real(2) * s * series;
}
