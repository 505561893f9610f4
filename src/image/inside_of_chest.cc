#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "prosup/image/body_labels.h"

namespace prosup::image {

namespace {

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
constexpr double widest_hole = 12.; // mm, from a column in it to its rim

/// The columns of voxels from the front of the body to its back.
class Columns {
public:
  Columns(LabelImage& labels, unsigned chest_label) : labels_(labels), chest_label_(chest_label) {
    const VoxelGrid& grid = labels.grid;
    for (unsigned d = 1; d < 3; ++d)
      if (std::abs(grid.direction[1][d]) > std::abs(grid.direction[1][axis_]))
        axis_ = d;
    runs_backwards_ = grid.direction[1][axis_] < 0.;
    across_ = {(axis_ + 1) % 3, (axis_ + 2) % 3};
    size_ = {grid.size[across_[0]], grid.size[across_[1]]};
    for (unsigned d = 0; d < 2; ++d)
      reach_[d] = std::ptrdiff_t(widest_hole / grid.spacing[across_[d]]);
    fronts_.resize(size_[0] * size_[1], nowhere);
    for (std::size_t a = 0; a < size_[0]; ++a)
      for (std::size_t b = 0; b < size_[1]; ++b)
        for (std::size_t i = 0; i < length() && front(a, b) == nowhere; ++i)
          if (voxel(a, b, i) == chest_label_)
            front(a, b) = i;
  }

  /// Returns the number of voxels that were filled.
  std::size_t fill() {
    std::size_t n = 0;
    for (std::size_t a = 0; a < size_[0]; ++a)
      for (std::size_t b = 0; b < size_[1]; ++b)
        n += fill_column(a, b);
    return n;
  }

private:
  std::size_t length() const { return labels_.grid.size[axis_]; }
  std::size_t& front(std::size_t a, std::size_t b) { return fronts_[a * size_[1] + b]; }

  std::uint8_t& voxel(std::size_t a, std::size_t b, std::size_t i) {
    std::array<std::size_t, 3> index{};
    index[across_[0]] = a;
    index[across_[1]] = b;
    index[axis_] = runs_backwards_ ? length() - 1 - i : i;
    return labels_(index[0], index[1], index[2]);
  }

  std::size_t fill_column(std::size_t a, std::size_t b) {
    const std::size_t from = front(a, b) == nowhere ? front_in_hole(a, b) : nowhere;
    std::size_t n = 0;
    bool is_inside = false, has_tissue = false;
    for (std::size_t i = 0; i < length(); ++i) {
      std::uint8_t& label = voxel(a, b, i);
      if (label != 0) {
        is_inside = label == chest_label_;
        has_tissue = true;
      } else if (is_inside || (has_tissue && i >= from)) {
        label = static_cast<std::uint8_t>(chest_label_);
        ++n;
      }
    }
    return n;
  }

  /// The front of the chest in a hole of its label: the hindmost of its rim to three sides at
  /// least.
  std::size_t front_in_hole(std::size_t a, std::size_t b) {
    std::size_t n_sides = 0, hindmost = 0;
    for (const auto& [da, db] :
         {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)})
      for (std::ptrdiff_t step = 1; step <= reach_[da == 0 ? 1 : 0]; ++step) {
        const std::ptrdiff_t i = std::ptrdiff_t(a) + da * step, j = std::ptrdiff_t(b) + db * step;
        if (i < 0 || j < 0 || i >= std::ptrdiff_t(size_[0]) || j >= std::ptrdiff_t(size_[1]))
          break;
        const std::size_t found = front(std::size_t(i), std::size_t(j));
        if (found == nowhere)
          continue;
        hindmost = std::max(hindmost, found);
        ++n_sides;
        break;
      }
    return n_sides >= 3 ? hindmost : nowhere;
  }

  LabelImage& labels_;
  const unsigned chest_label_;
  unsigned axis_ = 0;
  bool runs_backwards_ = false;
  std::array<unsigned, 2> across_{};
  std::array<std::size_t, 2> size_{};
  std::array<std::ptrdiff_t, 2> reach_{};
  std::vector<std::size_t> fronts_; // first voxel of chest in each column
};

} // namespace

LabelImage with_inside_of_chest(const LabelImage& labels, unsigned chest_label,
                                std::size_t* n_filled) {
  LabelImage result = labels;
  const std::size_t n = Columns(result, chest_label).fill();
  if (n_filled != nullptr)
    *n_filled = n;
  return result;
}

} // namespace prosup::image
