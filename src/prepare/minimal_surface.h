#ifndef PROSUP_SRC_PREPARE_MINIMAL_SURFACE_H
#define PROSUP_SRC_PREPARE_MINIMAL_SURFACE_H

#include <cstddef>
#include <vector>

namespace prosup::prepare {

/// The costs C of a surface that has one level l in each column of a grid of columns.
struct SurfaceCosts {
  SurfaceCosts(std::size_t n_rows_, std::size_t n_columns_, std::size_t n_levels_)
      : n_rows(n_rows_), n_columns(n_columns_), n_levels(n_levels_),
        values(n_rows * n_columns * n_levels, 0.f) {}

  float* at(std::size_t row, std::size_t column) {
    return values.data() + (row * n_columns + column) * n_levels;
  }
  const float* at(std::size_t row, std::size_t column) const {
    return values.data() + (row * n_columns + column) * n_levels;
  }

  std::size_t n_rows, n_columns, n_levels;
  std::vector<float> values; ///< levels run fastest
};

/// Levels l, row by row, that make
///   sum_p C_p(l_p) + sum_(p,q) min(slope |l_p - l_q|, largest)
/// small, where p and q are neighbouring columns: min-sum belief propagation (Felzenszwalb and
/// Huttenlocher, Int. J. Comput. Vis. 70, 2006) in `n_sweeps` sweeps over the grid.
std::vector<std::size_t> minimal_surface(const SurfaceCosts& costs, float slope, float largest,
                                         unsigned n_sweeps);

} // namespace prosup::prepare

#endif
