#include <algorithm>
#include <cmath>
#include <limits>

#include "prosup/core/error.h"
#include "prosup/image/filters.h"

namespace prosup::image {

namespace {

// Exact nearest-neighbour transform, axis by axis, through the lower envelope
// of parabolas (Felzenszwalb and Huttenlocher, Theory of Computing 8, 2012). ITK
// has Danielsson's approximation, several times slower.

constexpr float nothing = std::numeric_limits<float>::infinity();

struct NearestMap {
  std::vector<float> squared_distance; // mm^2
  std::vector<std::uint32_t> nearest;  // linear index of the nearest known voxel
};

/// Scratch space for one grid line, and the transform along it.
class LineTransform {
public:
  explicit LineTransform(std::size_t longest)
      : distance_(longest), nearest_(longest), vertex_(longest), from_(longest) {}

  /// Updates the `n` voxels first, first + stride, ... `spacing` apart.
  void run(NearestMap& map, std::size_t first, std::size_t stride, std::size_t n, double spacing) {
    for (std::size_t i = 0; i < n; ++i) {
      distance_[i] = map.squared_distance[first + i * stride];
      nearest_[i] = map.nearest[first + i * stride];
    }
    const std::size_t n_parabolas = build_envelope(n, spacing * spacing);
    for (std::size_t i = 0, p = 0; n_parabolas > 0 && i < n; ++i) {
      while (p + 1 < n_parabolas && from_[p + 1] <= double(i))
        ++p;
      const double away = (double(i) - double(vertex_[p])) * spacing;
      map.squared_distance[first + i * stride] =
          static_cast<float>(distance_[vertex_[p]] + away * away);
      map.nearest[first + i * stride] = nearest_[vertex_[p]];
    }
  }

private:
  /// Lists the vertices of the parabolas distance + s^2 (i - vertex)^2 that form
  /// the lower envelope, and from which i on each is the lowest.
  std::size_t build_envelope(std::size_t n, double s2) {
    std::size_t count = 0;
    for (std::size_t q = 0; q < n; ++q) {
      if (distance_[q] == nothing)
        continue;
      double start = -std::numeric_limits<double>::infinity();
      while (count > 0) {
        const std::size_t v = vertex_[count - 1];
        start = 0.5 * (double(q + v) +
                       (double(distance_[q]) - double(distance_[v])) / (s2 * double(q - v)));
        if (start > from_[count - 1])
          break;
        --count;
      }
      vertex_[count] = q;
      from_[count] = count == 0 ? -std::numeric_limits<double>::infinity() : start;
      ++count;
    }
    return count;
  }

  std::vector<float> distance_;
  std::vector<std::uint32_t> nearest_;
  std::vector<std::size_t> vertex_;
  std::vector<double> from_;
};

NearestMap nearest_known(const LabelImage& known) {
  const VoxelGrid& grid = known.grid;
  const auto& size = grid.size;
  NearestMap map{std::vector<float>(known.values.size(), nothing),
                 std::vector<std::uint32_t>(known.values.size(), 0)};
  for (std::size_t v = 0; v < known.values.size(); ++v)
    if (known.values[v] != 0) {
      map.squared_distance[v] = 0.f;
      map.nearest[v] = static_cast<std::uint32_t>(v);
    }
  LineTransform line(*std::max_element(size.begin(), size.end()));
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      line.run(map, grid.linear_index(0, j, k), 1, size[0], grid.spacing[0]);
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t i = 0; i < size[0]; ++i)
      line.run(map, grid.linear_index(i, 0, k), size[0], size[1], grid.spacing[1]);
  for (std::size_t j = 0; j < size[1]; ++j)
    for (std::size_t i = 0; i < size[0]; ++i)
      line.run(map, grid.linear_index(i, j, 0), size[0] * size[1], size[2], grid.spacing[2]);
  return map;
}

void require_known(const LabelImage& known) {
  if (std::all_of(known.values.begin(), known.values.end(), [](auto v) { return v == 0; }))
    throw Error("Nothing can be measured or extended from an empty mask; check the labels.");
}

} // namespace

ScalarImage distance_from(const LabelImage& known) {
  require_known(known);
  ScalarImage distance(known.grid);
  distance.values = nearest_known(known).squared_distance;
  for (float& value : distance.values)
    value = std::sqrt(value);
  return distance;
}

void extend_from_nearest(VectorImage& field, const LabelImage& known) {
  if (known.grid.size != field.grid.size)
    throw Error("A field can be extended only from a mask of its own size; resample the mask.");
  require_known(known);
  const NearestMap map = nearest_known(known);
  for (std::size_t v = 0; v < known.values.size(); ++v)
    if (known.values[v] == 0)
      field.values[v] = field.values[map.nearest[v]];
}

} // namespace prosup::image
