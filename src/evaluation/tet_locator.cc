#include "tet_locator.h"

#include <algorithm>
#include <cmath>

namespace prosup::evaluation {

namespace {

constexpr double tolerance_mm = 1e-9;

std::array<Point<3>, 4> corners_of(const std::array<unsigned, 4>& cell,
                                   const std::vector<Point<3>>& nodes) {
  return {nodes[cell[0]], nodes[cell[1]], nodes[cell[2]], nodes[cell[3]]};
}

/// Calls `visit(bin)` for all bins between two corners.
template <class Visit>
void for_each_bin(const std::array<std::ptrdiff_t, 3>& first,
                  const std::array<std::ptrdiff_t, 3>& last,
                  const std::array<std::ptrdiff_t, 3>& n_bins, Visit&& visit) {
  for (std::ptrdiff_t k = first[2]; k <= last[2]; ++k)
    for (std::ptrdiff_t j = first[1]; j <= last[1]; ++j)
      for (std::ptrdiff_t i = first[0]; i <= last[0]; ++i)
        visit(static_cast<std::size_t>(i + n_bins[0] * (j + n_bins[1] * k)));
}

} // namespace

TetLocator::TetLocator(const std::vector<Point<3>>& nodes, const Cells& cells) {
  affine_.reserve(cells.size());
  for (const auto& cell : cells)
    affine_.push_back(affine(corners_of(cell, nodes)));
  choose_bins(nodes, cells.size());
  sort_into_bins(nodes, cells);
}

TetLocator::Affine TetLocator::affine(const std::array<Point<3>, 4>& corners) {
  Affine result{corners[0], {}, 0.};
  const Tensor<1, 3> e1 = corners[1] - corners[0], e2 = corners[2] - corners[0],
                     e3 = corners[3] - corners[0];
  result.gradients = {cross_product_3d(e2, e3), cross_product_3d(e3, e1), cross_product_3d(e1, e2)};
  const double determinant = e1 * result.gradients[0];
  double steepest = 0.;
  for (auto& gradient : result.gradients) {
    gradient /= determinant;
    steepest += gradient.norm();
  }
  // The weights of a flat cell are not finite, or useless: no tolerance, however
  // large, lets them in.
  result.tolerance = steepest < 1e8 ? tolerance_mm * (1. + steepest) : -2.;
  return result;
}

void TetLocator::choose_bins(const std::vector<Point<3>>& nodes, std::size_t n_cells) {
  low_ = high_ = nodes[0];
  for (const Point<3>& p : nodes)
    for (unsigned d = 0; d < 3; ++d) {
      low_[d] = std::min(low_[d], p[d] - tolerance_mm);
      high_[d] = std::max(high_[d], p[d] + tolerance_mm);
    }
  const Tensor<1, 3> extent = high_ - low_;
  // About one bin per cell.
  const double edge = std::cbrt(extent[0] * extent[1] * extent[2] / static_cast<double>(n_cells));
  for (unsigned d = 0; d < 3; ++d) {
    n_bins_[d] = static_cast<std::ptrdiff_t>(std::clamp(std::ceil(extent[d] / edge), 1., 512.));
    bins_per_mm_[d] = static_cast<double>(n_bins_[d]) / extent[d];
  }
}

std::array<std::ptrdiff_t, 3> TetLocator::bin_of(const Point<3>& p) const {
  std::array<std::ptrdiff_t, 3> bin;
  for (unsigned d = 0; d < 3; ++d)
    bin[d] = std::clamp(static_cast<std::ptrdiff_t>((p[d] - low_[d]) * bins_per_mm_[d]),
                        std::ptrdiff_t(0), n_bins_[d] - 1);
  return bin;
}

void TetLocator::sort_into_bins(const std::vector<Point<3>>& nodes, const Cells& cells) {
  const auto visit_bins = [&](std::size_t cell, auto&& visit) {
    const auto corners = corners_of(cells[cell], nodes);
    Point<3> low = corners[0], high = corners[0];
    for (const Point<3>& p : corners)
      for (unsigned d = 0; d < 3; ++d) {
        low[d] = std::min(low[d], p[d] - tolerance_mm);
        high[d] = std::max(high[d], p[d] + tolerance_mm);
      }
    for_each_bin(bin_of(low), bin_of(high), n_bins_, visit);
  };
  first_in_bin_.assign(static_cast<std::size_t>(n_bins_[0] * n_bins_[1] * n_bins_[2]) + 1, 0);
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    visit_bins(cell, [&](std::size_t bin) { ++first_in_bin_[bin + 1]; });
  for (std::size_t bin = 1; bin < first_in_bin_.size(); ++bin)
    first_in_bin_[bin] += first_in_bin_[bin - 1];
  cells_in_bins_.resize(first_in_bin_.back());
  std::vector<std::size_t> next(first_in_bin_.begin(), first_in_bin_.end() - 1);
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    visit_bins(cell,
               [&](std::size_t bin) { cells_in_bins_[next[bin]++] = static_cast<unsigned>(cell); });
}

std::optional<TetLocator::Hit> TetLocator::find(const Point<3>& p) const {
  for (unsigned d = 0; d < 3; ++d)
    if (!(p[d] >= low_[d] && p[d] <= high_[d]))
      return {};
  const auto [i, j, k] = bin_of(p);
  const auto bin = static_cast<std::size_t>(i + n_bins_[0] * (j + n_bins_[1] * k));
  for (std::size_t c = first_in_bin_[bin]; c < first_in_bin_[bin + 1]; ++c) {
    const Affine& cell = affine_[cells_in_bins_[c]];
    const Tensor<1, 3> r = p - cell.origin;
    const double w1 = cell.gradients[0] * r, w2 = cell.gradients[1] * r, w3 = cell.gradients[2] * r,
                 w0 = 1. - w1 - w2 - w3;
    if (std::min({w0, w1, w2, w3}) >= -cell.tolerance)
      return Hit{cells_in_bins_[c], {w0, w1, w2, w3}};
  }
  return {};
}

} // namespace prosup::evaluation
