#include "minimal_surface.h"

#include <algorithm>
#include <array>

namespace prosup::prepare {

namespace {

/// Where a message comes from.
enum Side { left, right, below, above };
constexpr unsigned n_sides = 4;

class BeliefPropagation {
public:
  BeliefPropagation(const SurfaceCosts& costs, float slope, float largest)
      : costs_(costs), slope_(slope), largest_(largest),
        messages_(n_sides, SurfaceCosts(costs.n_rows, costs.n_columns, costs.n_levels)),
        belief_(costs.n_levels) {}

  void sweep() {
    for (std::size_t r = 0; r < costs_.n_rows; ++r) {
      for (std::size_t c = 1; c < costs_.n_columns; ++c)
        send(r, c - 1, r, c, left);
      for (std::size_t c = costs_.n_columns - 1; c > 0; --c)
        send(r, c, r, c - 1, right);
    }
    for (std::size_t c = 0; c < costs_.n_columns; ++c) {
      for (std::size_t r = 1; r < costs_.n_rows; ++r)
        send(r - 1, c, r, c, below);
      for (std::size_t r = costs_.n_rows - 1; r > 0; --r)
        send(r, c, r - 1, c, above);
    }
  }

  std::size_t best(std::size_t row, std::size_t column) {
    gather(row, column, n_sides);
    return std::size_t(std::min_element(belief_.begin(), belief_.end()) - belief_.begin());
  }

private:
  /// What a column believes, without what it was told from one side.
  void gather(std::size_t row, std::size_t column, unsigned without) {
    const float* cost = costs_.at(row, column);
    std::copy_n(cost, costs_.n_levels, belief_.begin());
    for (unsigned side = 0; side < n_sides; ++side) {
      if (side == without)
        continue;
      const float* message = messages_[side].at(row, column);
      for (std::size_t l = 0; l < costs_.n_levels; ++l)
        belief_[l] += message[l];
    }
  }

  /// Tells a neighbour, which hears it from `side`.
  void send(std::size_t row, std::size_t column, std::size_t to_row, std::size_t to_column,
            Side side) {
    static constexpr std::array<Side, n_sides> opposite{right, left, above, below};
    gather(row, column, opposite[side]);
    const std::size_t n = costs_.n_levels;
    const float smallest = *std::min_element(belief_.begin(), belief_.end());
    for (std::size_t l = 1; l < n; ++l)
      belief_[l] = std::min(belief_[l], belief_[l - 1] + slope_);
    for (std::size_t l = n - 1; l > 0; --l)
      belief_[l - 1] = std::min(belief_[l - 1], belief_[l] + slope_);
    float* message = messages_[side].at(to_row, to_column);
    for (std::size_t l = 0; l < n; ++l)
      message[l] = std::min(belief_[l] - smallest, largest_);
  }

  const SurfaceCosts& costs_;
  const float slope_, largest_;
  std::vector<SurfaceCosts> messages_; // by the side that they come from
  std::vector<float> belief_;
};

} // namespace

std::vector<std::size_t> minimal_surface(const SurfaceCosts& costs, float slope, float largest,
                                         unsigned n_sweeps) {
  BeliefPropagation propagation(costs, slope, largest);
  for (unsigned sweep = 0; sweep < n_sweeps; ++sweep)
    propagation.sweep();
  std::vector<std::size_t> levels;
  levels.reserve(costs.n_rows * costs.n_columns);
  for (std::size_t r = 0; r < costs.n_rows; ++r)
    for (std::size_t c = 0; c < costs.n_columns; ++c)
      levels.push_back(propagation.best(r, c));
  return levels;
}

} // namespace prosup::prepare
