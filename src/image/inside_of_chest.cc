#include <array>
#include <cmath>

#include "prosup/image/body_labels.h"

namespace prosup::image {

LabelImage with_inside_of_chest(const LabelImage& labels, unsigned chest_label,
                                std::size_t* n_filled) {
  const VoxelGrid& grid = labels.grid;
  unsigned axis = 0;
  for (unsigned d = 1; d < 3; ++d)
    if (std::abs(grid.direction[1][d]) > std::abs(grid.direction[1][axis]))
      axis = d;
  const bool runs_backwards = grid.direction[1][axis] < 0.;
  const unsigned first = (axis + 1) % 3, second = (axis + 2) % 3;
  LabelImage result = labels;
  std::size_t n = 0;
  std::array<std::size_t, 3> index{};
  for (std::size_t a = 0; a < grid.size[first]; ++a)
    for (std::size_t b = 0; b < grid.size[second]; ++b) {
      index[first] = a;
      index[second] = b;
      bool is_inside = false;
      for (std::size_t i = 0; i < grid.size[axis]; ++i) {
        index[axis] = runs_backwards ? grid.size[axis] - 1 - i : i;
        std::uint8_t& label = result(index[0], index[1], index[2]);
        if (label != 0)
          is_inside = label == chest_label;
        else if (is_inside) {
          label = static_cast<std::uint8_t>(chest_label);
          ++n;
        }
      }
    }
  if (n_filled != nullptr)
    *n_filled = n;
  return result;
}

} // namespace prosup::image
