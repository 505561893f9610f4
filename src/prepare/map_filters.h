#ifndef PROSUP_SRC_PREPARE_MAP_FILTERS_H
#define PROSUP_SRC_PREPARE_MAP_FILTERS_H

#include <cstddef>
#include <vector>

namespace prosup::prepare {

/// Values on a grid of columns, row by row; no number where nothing is known.
struct ColumnMap {
  ColumnMap() = default;
  ColumnMap(std::size_t n_rows_, std::size_t n_columns_, double value = 0.)
      : n_rows(n_rows_), n_columns(n_columns_), values(n_rows * n_columns, value) {}

  double& operator()(std::size_t row, std::size_t column) {
    return values[row * n_columns + column];
  }
  double operator()(std::size_t row, std::size_t column) const {
    return values[row * n_columns + column];
  }

  std::size_t n_rows = 0, n_columns = 0;
  std::vector<double> values;
};

/// quantile() of those values that are known; no number if nothing is known.
double quantile_of(std::vector<double> values, double share);

/// Median of the known values in a window of 2 * half + 1 columns.
ColumnMap median_filtered(const ColumnMap& map, std::size_t half_rows, std::size_t half_columns);

/// Mean of the known values with Gaussian weights, `sigma` in columns.
ColumnMap smoothed(const ColumnMap& map, double sigma);

} // namespace prosup::prepare

#endif
