#include "map_filters.h"

#include "prosup/core/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace prosup::prepare {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The part of 0 .. n - 1 that is `half` or less from `middle`.
struct Window {
  Window(std::size_t middle, std::size_t half, std::size_t n)
      : first(middle > half ? middle - half : 0), end(std::min(middle + half + 1, n)) {}
  std::size_t first, end;
};

} // namespace

double quantile_of(std::vector<double> values, double share) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return std::isnan(v); }),
               values.end());
  return values.empty() ? unknown : quantile(std::move(values), share);
}

ColumnMap median_filtered(const ColumnMap& map, std::size_t half_rows, std::size_t half_columns) {
  ColumnMap result(map.n_rows, map.n_columns);
  std::vector<double> values;
  for (std::size_t r = 0; r < map.n_rows; ++r)
    for (std::size_t c = 0; c < map.n_columns; ++c) {
      values.clear();
      const Window rows(r, half_rows, map.n_rows), columns(c, half_columns, map.n_columns);
      for (std::size_t i = rows.first; i < rows.end; ++i)
        for (std::size_t j = columns.first; j < columns.end; ++j)
          values.push_back(map(i, j));
      result(r, c) = quantile_of(values, 0.5);
    }
  return result;
}

ColumnMap smoothed(const ColumnMap& map, double sigma) {
  const auto half = static_cast<std::size_t>(std::ceil(3. * sigma));
  std::vector<double> weight(half + 1);
  for (std::size_t i = 0; i <= half; ++i)
    weight[i] = std::exp(-0.5 * double(i * i) / (sigma * sigma));
  ColumnMap result(map.n_rows, map.n_columns);
  for (std::size_t r = 0; r < map.n_rows; ++r)
    for (std::size_t c = 0; c < map.n_columns; ++c) {
      double sum = 0., total = 0.;
      const Window rows(r, half, map.n_rows), columns(c, half, map.n_columns);
      for (std::size_t i = rows.first; i < rows.end; ++i)
        for (std::size_t j = columns.first; j < columns.end; ++j) {
          if (std::isnan(map(i, j)))
            continue;
          const double w = weight[i > r ? i - r : r - i] * weight[j > c ? j - c : c - j];
          sum += w * map(i, j);
          total += w;
        }
      result(r, c) = total > 0. ? sum / total : unknown;
    }
  return result;
}

} // namespace prosup::prepare
