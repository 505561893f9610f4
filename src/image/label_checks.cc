#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/image_io.h"
#include "voxel_checks.h"

namespace prosup::image {

namespace {

std::string text(const Tensor<1, 3>& v) {
  return format("(%g, %g, %g)", v[0], v[1], v[2]);
}

std::string text(const Tensor<2, 3>& m) {
  return "(" + text(m[0]) + ", " + text(m[1]) + ", " + text(m[2]) + ")";
}

std::string text(const std::array<std::size_t, 3>& size) {
  return format("%zu x %zu x %zu", size[0], size[1], size[2]);
}

/// The property by which two grids that do not coincide differ, as
/// "spacing (1, 1, 2) mm against (1, 1, 1) mm"; `a` is the first value. The size is passed over if
/// `but_size`.
std::string difference(const VoxelGrid& a, const VoxelGrid& b, bool but_size) {
  if (a.size != b.size && !but_size)
    return "size " + text(a.size) + " voxels against " + text(b.size);
  VoxelGrid c = b;
  c.size = a.size;
  c.origin = a.origin;
  c.direction = a.direction;
  if (!a.coincides_with(c))
    return "spacing " + text(a.spacing) + " mm against " + text(b.spacing) + " mm";
  c.direction = b.direction;
  if (!a.coincides_with(c))
    return "direction cosines " + text(a.direction) + " against " + text(b.direction);
  return "origin " + text(a.origin) + " mm against " + text(b.origin) + " mm";
}

/// Whether the axes of two grids are parallel, in any order and sense, to 0.1 degrees.
bool are_parallel(const VoxelGrid& a, const VoxelGrid& b) {
  constexpr double sine = 2e-3;
  const Tensor<2, 3> cosines = transpose(a.direction) * b.direction;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      if (std::abs(cosines[i][j]) > sine && std::abs(cosines[i][j]) < 1. - sine)
        return false;
  return true;
}

/// The voxel of `grid` that holds a position, or nothing outside of them.
std::optional<std::size_t> voxel_at(const VoxelGrid& grid, const Point<3>& x) {
  const Point<3> index = grid.continuous_index(x);
  std::array<std::size_t, 3> nearest{};
  for (unsigned d = 0; d < 3; ++d) {
    const double rounded = std::round(index[d]);
    if (!(rounded >= 0. && rounded < double(grid.size[d])))
      return {};
    nearest[d] = static_cast<std::size_t>(rounded);
  }
  return grid.linear_index(nearest[0], nearest[1], nearest[2]);
}

/// The share of the voxels with a label that lie within `grid`.
double share_inside(const LabelImage& labels, const VoxelGrid& grid) {
  std::size_t n_labelled = 0, n_inside = 0;
  for (std::size_t v = 0; v < labels.values.size(); ++v)
    if (labels.values[v] != 0) {
      ++n_labelled;
      n_inside += voxel_at(grid, voxel_position(labels.grid, v)).has_value();
    }
  return n_labelled == 0 ? 1. : double(n_inside) / double(n_labelled);
}

LabelImage nearest_labels(const LabelImage& labels, const VoxelGrid& grid) {
  LabelImage result(grid);
  for (std::size_t v = 0; v < result.values.size(); ++v)
    if (const auto voxel = voxel_at(labels.grid, voxel_position(grid, v)))
      result.values[v] = labels.values[*voxel];
  return result;
}

/// How much the voxels of an image are like their neighbours, apart from those of its background.
class Neighbours {
public:
  explicit Neighbours(const LabelImage& labels) {
    const std::size_t row = labels.grid.size[0];
    for (std::size_t v = 0; v < labels.values.size(); ++v) {
      const std::uint8_t value = labels.values[v];
      occurs_[value] = true;
      if (v % row != 0 && (value != 0 || labels.values[v - 1] != 0)) {
        ++n_pairs_;
        n_alike_ += value == labels.values[v - 1];
      }
    }
  }

  std::size_t n_values() const {
    return std::size_t(std::count(occurs_.begin(), occurs_.end(), true));
  }
  double share_alike() const { return double(n_alike_) / std::max(double(n_pairs_), 1.); }

  bool are_regions() const {
    constexpr std::size_t few_values = 12; // can be labels, whatever they look like
    constexpr double least_alike = 0.6;    // of neighbours; even thin regions have more
    return n_values() <= few_values || share_alike() >= least_alike;
  }

private:
  std::array<bool, 256> occurs_{};
  std::size_t n_pairs_ = 0, n_alike_ = 0;
};

} // namespace

LabelImage fit_labels(LabelImage labels, const ScalarImage& image, const std::string& labels_name,
                      const std::string& image_name, Remarks& remarks) {
  constexpr double rounding = 0.1; // voxels: what headers of one scan differ by
  const VoxelGrid& grid = image.grid;
  if (labels.grid.coincides_with(grid, rounding)) {
    labels.grid = grid;
    return labels;
  }
  // Labels with as many voxels were made on those of the image: one of the headers is wrong.
  const bool same_size = labels.grid.size == grid.size;
  const bool parallel = are_parallel(labels.grid, grid);
  if ((same_size && !labels.grid.coincides_with(grid, 1.)) || !parallel)
    throw Error(
        format("The labels '%s' do not lie on the voxels of the image '%s': %s; correct the "
               "header that is wrong, or resample the labels to the image.",
               labels_name.c_str(), image_name.c_str(),
               difference(labels.grid, grid, same_size || !parallel).c_str()));
  const double inside = share_inside(labels, grid);
  constexpr double least_inside = 0.5;
  if (inside < least_inside)
    throw Error(format("The labels '%s' lie elsewhere than the image '%s': only %.0f %% of their "
                       "voxels that are not 0 lie within it (%s); give the labels of this image.",
                       labels_name.c_str(), image_name.c_str(), 100. * inside,
                       difference(labels.grid, grid, true).c_str()));
  const std::string lost =
      inside < 0.999 ? format(", where %.1f %% of them are lost", 100. * (1. - inside)) : "";
  remarks.add(format("The labels '%s' do not lie on the voxels of the image '%s' (%s); they were "
                     "resampled to them by the nearest voxel, with air around%s.",
                     labels_name.c_str(), image_name.c_str(),
                     difference(labels.grid, grid, same_size).c_str(), lost.c_str()));
  return nearest_labels(labels, grid);
}

bool marks_regions(const ScalarImage& image) {
  LabelImage labels(image.grid);
  for (std::size_t v = 0; v < image.values.size(); ++v) {
    const float value = image.values[v];
    if (!(value >= 0.f && value <= 255.f) || value != std::floor(value))
      return false;
    labels.values[v] = static_cast<std::uint8_t>(value);
  }
  return Neighbours(labels).are_regions();
}

void require_regions(const LabelImage& labels, const std::string& file) {
  const Neighbours found(labels);
  if (!found.are_regions())
    throw Error(format("'%s' is no label image: it holds %zu different values, and only %.0f %% of "
                       "neighbouring voxels have the same one; give the mask, not the image.",
                       file.c_str(), found.n_values(), 100. * found.share_alike()));
}

void require_label(const LabelImage& labels, unsigned label, const std::string& what,
                   const std::string& file) {
  std::vector<bool> occurs(256, false);
  for (const std::uint8_t value : labels.values)
    occurs[value] = true;
  if (label < occurs.size() && occurs[label])
    return;
  std::string present;
  for (std::size_t l = 0; l < occurs.size(); ++l)
    if (occurs[l])
      present += (present.empty() ? "" : ", ") + std::to_string(l);
  throw Error(format("The labels '%s' have no voxel of label %u (%s), only of %s; set the number "
                     "of that label or correct the mask.",
                     file.c_str(), label, what.c_str(),
                     present.empty() ? "none" : present.c_str()));
}

} // namespace prosup::image
