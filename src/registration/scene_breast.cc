#include "scene_breast.h"

#include <algorithm>
#include <cmath>

#include "prosup/image/filters.h"
#include "scene_maps.h"

namespace prosup::registration {

using dealii::Point;
using dealii::Tensor;
using image::LabelImage;
using image::VoxelGrid;

namespace {

constexpr double reach_percentile = 0.95;
/// Faces that look to the front by this cosine are front faces.
constexpr double front_cosine = 0.7;

/// Areas and normals of the faces of all voxels.
class Faces {
public:
  Faces(BreastMeasures& result, const Labels& meaning)
      : result_(result), labels_(result.labels), is_tissue_(tissue_table(meaning)),
        meaning_(meaning) {}

  void run() {
    const auto& size = labels_.grid.size;
    for (std::size_t k = 0; k < size[2]; ++k)
      for (std::size_t j = 0; j < size[1]; ++j)
        for (std::size_t i = 0; i < size[0]; ++i)
          visit({i, j, k});
    const double length = normal_.norm();
    result_.agreement = result_.base_area > 0. ? length / result_.base_area : 0.;
    result_.front = length > 0. ? normal_ / length : normal_;
  }

  /// Once it is known where the front is.
  void find_front() {
    for (unsigned d = 0; d < 3; ++d)
      for (const int side : {0, 1})
        if ((side == 0 ? -1. : 1.) * (axis(d) * result_.front) > front_cosine)
          result_.front_area += border_[d][std::size_t(side)];
  }

private:
  using Index = std::array<std::size_t, 3>;

  Tensor<1, 3> axis(unsigned d) const {
    Tensor<1, 3> column;
    for (unsigned e = 0; e < 3; ++e)
      column[e] = labels_.grid.direction[e][d];
    return column;
  }

  void visit(const Index& at) {
    const auto& [size, spacing] = std::tie(labels_.grid.size, labels_.grid.spacing);
    const std::uint8_t here = labels_(at[0], at[1], at[2]);
    std::size_t stride = 1;
    const std::size_t v = labels_.grid.linear_index(at[0], at[1], at[2]);
    for (unsigned d = 0; d < 3; stride *= size[d], ++d) {
      const double area = labels_.grid.voxel_volume() / spacing[d];
      if (is_tissue_[here] && at[d] == 0)
        border(d, 0, area);
      if (at[d] + 1 < size[d])
        face(at, d, here, labels_.values[v + stride], area);
      else if (is_tissue_[here])
        border(d, 1, area);
    }
  }

  void border(unsigned d, std::size_t side, double area) {
    result_.border_area += area;
    border_[d][side] += area;
  }

  void face(const Index& at, unsigned d, std::uint8_t here, std::uint8_t next, double area) {
    if (is_tissue_[here] == is_tissue_[next])
      return;
    const std::uint8_t tissue = is_tissue_[here] ? here : next;
    const std::uint8_t neighbour = is_tissue_[here] ? next : here;
    if (neighbour == meaning_.chest) {
      result_.base_area += area;
      normal_ += (is_tissue_[next] ? area : -area) * axis(d);
      double x[3] = {double(at[0]), double(at[1]), double(at[2])};
      x[d] += 0.5;
      result_.base.push_back(labels_.grid.physical(x[0], x[1], x[2]));
    } else {
      result_.skin_area += area;
      if (tissue == meaning_.gland)
        result_.gland_skin_area += area;
    }
  }

  BreastMeasures& result_;
  const LabelImage& labels_;
  const std::array<bool, 256> is_tissue_;
  const Labels& meaning_;
  Tensor<1, 3> normal_;
  std::array<std::array<double, 2>, 3> border_{};
};

std::size_t count(const LabelImage& mask) {
  return std::size_t(std::count_if(mask.values.begin(), mask.values.end(),
                                   [](std::uint8_t value) { return value != 0; }));
}

void measure_volumes(const LabelImage& labels, const Labels& meaning, BreastMeasures& result) {
  for (const std::uint8_t label : labels.values)
    ++result.counts[label];
  result.voxel_ml = labels.grid.voxel_volume() / 1000.;
  for (const unsigned tissue : meaning.tissues)
    result.tissue_ml += result.voxel_ml * double(result.counts[tissue]);
  if (meaning.gland != 0)
    result.gland_ml = result.voxel_ml * double(result.counts[meaning.gland]);
}

void measure_parts(const LabelImage& tissue, BreastMeasures& result) {
  const double n = double(count(tissue));
  result.solid = n * tissue.grid.voxel_volume() / 1000. / result.tissue_ml;
  result.largest_part = n > 0. ? double(count(image::largest_component(tissue))) / n : 0.;
}

void measure_distance(const LabelImage& tissue, const Labels& meaning, BreastMeasures& result) {
  // Specks of chest within the tissue would bring all of it near to the chest.
  const LabelImage chest =
      image::largest_component(image::select_labels(result.labels, {meaning.chest}));
  const std::size_t n = count(chest);
  if (n == 0 || n == chest.values.size())
    return;
  result.chest_distance = image::signed_distance(chest);
  std::vector<float> distances;
  for (std::size_t v = 0; v < tissue.values.size(); ++v)
    if (tissue.values[v] != 0)
      distances.push_back(result.chest_distance.values[v]);
  if (distances.empty())
    return;
  const auto rank = std::ptrdiff_t(reach_percentile * double(distances.size() - 1));
  std::nth_element(distances.begin(), distances.begin() + rank, distances.end());
  result.reach = distances[std::size_t(rank)];
}

} // namespace

std::array<bool, 256> tissue_table(const Labels& meaning) {
  std::array<bool, 256> table{};
  for (const unsigned tissue : meaning.tissues)
    table[tissue] = true;
  return table;
}

template <typename T>
image::VoxelImage<T> thinned(const image::VoxelImage<T>& image, double edge) {
  VoxelGrid grid = image.grid;
  std::array<std::size_t, 3> step{}, first{};
  for (unsigned d = 0; d < 3; ++d) {
    step[d] = std::clamp<std::size_t>(std::size_t(edge / grid.spacing[d] + 1e-6), 1,
                                      std::max<std::size_t>(grid.size[d], 1));
    first[d] = step[d] / 2;
    grid.size[d] = (grid.size[d] + step[d] - 1 - first[d]) / step[d];
    grid.spacing[d] *= double(step[d]);
  }
  grid.origin = image.grid.physical(double(first[0]), double(first[1]), double(first[2]));
  image::VoxelImage<T> result(grid);
  std::size_t v = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        result.values[v++] =
            image(first[0] + i * step[0], first[1] + j * step[1], first[2] + k * step[2]);
  return result;
}

template LabelImage thinned(const LabelImage&, double);
template image::ScalarImage thinned(const image::ScalarImage&, double);

BreastMeasures measure(const LabelImage& labels, const Labels& meaning, double edge) {
  BreastMeasures result;
  measure_volumes(labels, meaning, result);
  result.labels = thinned(labels, edge);
  const LabelImage tissue = image::select_labels(result.labels, meaning.tissues);
  measure_parts(tissue, result);
  Faces faces(result, meaning);
  faces.run();
  faces.find_front();
  measure_distance(tissue, meaning, result);
  result.covered = share_with_chest_behind(result, meaning);
  return result;
}

} // namespace prosup::registration
