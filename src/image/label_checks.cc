#include <array>
#include <string>
#include <vector>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/image_io.h"

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
/// "spacing (1, 1, 2) mm against (1, 1, 1) mm"; `a` is the first value.
std::string difference(const VoxelGrid& a, const VoxelGrid& b) {
  if (a.size != b.size)
    return "size " + text(a.size) + " voxels against " + text(b.size);
  VoxelGrid c = b;
  c.origin = a.origin;
  c.direction = a.direction;
  if (!a.coincides_with(c))
    return "spacing " + text(a.spacing) + " mm against " + text(b.spacing) + " mm";
  c.direction = b.direction;
  if (!a.coincides_with(c))
    return "direction cosines " + text(a.direction) + " against " + text(b.direction);
  return "origin " + text(a.origin) + " mm against " + text(b.origin) + " mm";
}

} // namespace

void check_labels_fit(const ScalarImage& image, const LabelImage& labels,
                      const std::string& image_name, const std::string& labels_name) {
  if (!labels.grid.coincides_with(image.grid))
    throw Error(format("The labels '%s' do not lie on the voxels of the image '%s': %s; resample "
                       "the labels to the image.",
                       labels_name.c_str(), image_name.c_str(),
                       difference(labels.grid, image.grid).c_str()));
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
