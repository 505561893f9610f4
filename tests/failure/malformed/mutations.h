#ifndef PROSUP_TESTS_MUTATIONS_H
#define PROSUP_TESTS_MUTATIONS_H

#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace prosup::tests {

/// The bytes of a file that was right, and what was done to it.
struct Mutation {
  std::string what, bytes;
};
using Mutations = std::vector<Mutation>;

inline Mutations operator+(Mutations a, const Mutations& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// The file cut off at `n` places: close to each other at its beginning, where the header is.
inline Mutations truncated(const std::string& whole, unsigned n) {
  Mutations result;
  for (unsigned i = 0; i < n; ++i) {
    const std::size_t length = whole.size() * i * i / (n * n);
    result.push_back({"cut to " + std::to_string(length) + " bytes", whole.substr(0, length)});
  }
  return result;
}

/// One byte inverted, at `n` places between `begin` and `end`.
inline Mutations damaged(const std::string& whole, std::size_t begin, std::size_t end, unsigned n) {
  Mutations result;
  for (unsigned i = 0; i < n; ++i) {
    const std::size_t at = begin + (end - begin) * i / n;
    result.push_back({"byte " + std::to_string(at) + " inverted", whole});
    result.back().bytes[at] = static_cast<char>(~result.back().bytes[at]);
  }
  return result;
}

/// The number at byte `at` replaced by extreme ones of its type.
template <typename Number>
Mutations extreme(const std::string& whole, std::size_t at) {
  using Limits = std::numeric_limits<Number>;
  std::vector<Number> values{Number(0), Number(-1), Number(3), Limits::max(), Limits::lowest()};
  if (Limits::has_infinity)
    values.insert(values.end(), {Limits::quiet_NaN(), Limits::infinity(), Limits::min()});
  Mutations result;
  for (const Number value : values) {
    result.push_back({"byte " + std::to_string(at) + " holds " + std::to_string(value), whole});
    std::memcpy(result.back().bytes.data() + at, &value, sizeof(value));
  }
  return result;
}

/// The lines of a text header up to the byte `end`, one after the other left out, doubled, and with
/// other values after the first `separator`.
inline Mutations changed_lines(const std::string& whole, std::size_t end,
                               const std::string& separator) {
  const std::vector<std::string> values{"",
                                        "0",
                                        "-1",
                                        "nan",
                                        "1e999",
                                        "4 4 4 4 4",
                                        "none",
                                        "%d%s",
                                        "99999999999999999999",
                                        "99999 99999 99999",
                                        "0 0 0 0 0 0 0 0 0",
                                        "(0,0,0) (0,0,0) (0,0,0)",
                                        "../x",
                                        "(((("};
  Mutations result;
  for (std::size_t begin = 0; begin < end;) {
    const std::size_t next = std::min(whole.find('\n', begin), whole.size() - 1) + 1;
    const std::string before = whole.substr(0, begin), line = whole.substr(begin, next - begin),
                      after = whole.substr(next);
    const std::string named = "line '" + line.substr(0, line.find('\n')) + "' ";
    result.push_back({named + "left out", before + after});
    result.push_back({named + "twice", before + line + line + after});
    const std::size_t key = line.find(separator);
    for (const std::string& value : values)
      if (key != std::string::npos)
        result.push_back({named + "says '" + value + "'",
                          before + line.substr(0, key + separator.size()) + value + "\n" + after});
    begin = next;
  }
  return result;
}

} // namespace prosup::tests

#endif
