#include <algorithm>
#include <array>
#include <cmath>

#include "prosup/image/body_labels.h"
#include "prosup/image/filters.h"

namespace prosup::image {

namespace {

constexpr double coarse = 2.;    // mm: a neck is seen on voxels of about this size
constexpr double half_neck = 3.; // mm
constexpr double surroundings = 4. * half_neck;
constexpr double largest = 0.05; // of the tissue; a larger part is more than noise

using Index = std::array<std::size_t, 3>;

/// Each n-th voxel of an image.
class Thinned {
public:
  explicit Thinned(const VoxelGrid& grid) : fine_(grid.size), grid_(grid) {
    for (unsigned d = 0; d < 3; ++d) {
      step_[d] = std::max(std::size_t(1), std::size_t(std::lround(coarse / grid.spacing[d])));
      grid_.size[d] = (grid.size[d] - 1) / step_[d] + 1;
      grid_.spacing[d] = grid.spacing[d] * double(step_[d]);
    }
  }

  /// 1 where the label is not 0.
  LabelImage body(const LabelImage& labels) const {
    LabelImage body(grid_);
    std::size_t v = 0;
    for (std::size_t k = 0; k < grid_.size[2]; ++k)
      for (std::size_t j = 0; j < grid_.size[1]; ++j)
        for (std::size_t i = 0; i < grid_.size[0]; ++i, ++v)
          body.values[v] = labels(i * step_[0], j * step_[1], k * step_[2]) != 0;
    return body;
  }

  /// Calls function(fine voxel, nearest voxel of the thinned grid) for all fine voxels.
  template <typename Function>
  void for_each_voxel(const Function& function) const {
    std::size_t v = 0;
    for (std::size_t k = 0; k < fine_[2]; ++k)
      for (std::size_t j = 0; j < fine_[1]; ++j)
        for (std::size_t i = 0; i < fine_[0]; ++i, ++v)
          function(v, grid_.linear_index(nearest(i, 0), nearest(j, 1), nearest(k, 2)));
  }

private:
  std::size_t nearest(std::size_t i, unsigned d) const {
    return std::min((i + step_[d] / 2) / step_[d], grid_.size[d] - 1);
  }

  Index fine_, step_{};
  VoxelGrid grid_;
};

bool is_empty(const LabelImage& mask) {
  return std::all_of(mask.values.begin(), mask.values.end(), [](auto v) { return v == 0; });
}

/// The surroundings of all cores but the largest one, as far as they are no surroundings of it.
LabelImage hanging(const LabelImage& body) {
  LabelImage none(body.grid);
  if (is_empty(body) ||
      std::all_of(body.values.begin(), body.values.end(), [](auto v) { return v != 0; }))
    return none;
  const ScalarImage distance = signed_distance(body);
  LabelImage core(body.grid);
  std::transform(distance.values.begin(), distance.values.end(), core.values.begin(),
                 [](float d) { return d < -half_neck; });
  const LabelImage main = largest_component(core);
  for (std::size_t v = 0; v < core.values.size(); ++v)
    core.values[v] = core.values[v] != 0 && main.values[v] == 0;
  if (is_empty(core))
    return none;
  const ScalarImage to_other = distance_from(core), to_main = distance_from(main);
  const auto& spacing = body.grid.spacing;
  const double reach = half_neck + std::max({spacing[0], spacing[1], spacing[2]});
  for (std::size_t v = 0; v < none.values.size(); ++v)
    none.values[v] = to_main.values[v] > reach &&
                     to_other.values[v] < std::min(surroundings, double(to_main.values[v]));
  return none;
}

} // namespace

std::optional<HangingParts> take_off_hanging_parts(LabelImage& labels, unsigned chest_label) {
  if (labels.values.empty()) // a mesh that was given needs none
    return std::nullopt;
  const Thinned thinned(labels.grid);
  const LabelImage parts = hanging(thinned.body(labels));
  if (is_empty(parts))
    return std::nullopt;
  const auto is_tissue = [&](std::size_t v) {
    return labels.values[v] != 0 && labels.values[v] != chest_label;
  };
  std::size_t n_tissue = 0;
  std::vector<std::size_t> found;
  thinned.for_each_voxel([&](std::size_t v, std::size_t nearest) {
    n_tissue += is_tissue(v);
    if (is_tissue(v) && parts.values[nearest] != 0)
      found.push_back(v);
  });
  if (found.empty() || double(found.size()) > largest * double(n_tissue))
    return std::nullopt;
  HangingParts result;
  result.volume = double(found.size()) * labels.grid.voxel_volume();
  for (const std::size_t v : found) {
    const std::size_t row = labels.grid.size[0], slice = row * labels.grid.size[1];
    const std::size_t i = v % row, j = v % slice / row, k = v / slice;
    result.centre +=
        Tensor<1, 3>(labels.grid.physical(double(i), double(j), double(k))) / double(found.size());
    labels.values[v] = 0;
  }
  return result;
}

} // namespace prosup::image
