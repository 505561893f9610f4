#ifndef PROSUP_CORE_QUANTILE_H
#define PROSUP_CORE_QUANTILE_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace prosup {

/// The value below which `part` (0 to 1) of the values lie, by the nearest rank, the upper of two;
/// 0 if there are none.
template <typename T>
T quantile(std::vector<T> values, double part) {
  if (values.empty())
    return T();
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

} // namespace prosup

#endif
