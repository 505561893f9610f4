#include <algorithm>
#include <array>

#include "prosup/image/body_labels.h"
#include "prosup/image/voxel_box.h"

namespace prosup::image {

namespace {

// A sphere of 100 mm radius shows 314 mm^2 of skin in one plane of voxels of 0.5 mm, and as much in
// the next plane; a cut shows next to nothing there.
constexpr double least_area = 300.; // of tissue, mm^2
constexpr double least_jump = 5.;   // over the larger area in the planes beside it

// Of the tissue: more beyond the plane is a part of the breast that does not end there.
constexpr double most_beyond = 0.01;

/// Ends of the body in the planes of voxel faces across one axis, in number of faces. Plane p lies
/// between the voxels p - 1 and p.
struct Planes {
  std::vector<double> lower, upper;               ///< where the body begins, and where it ends
  std::vector<double> tissue_lower, tissue_upper; ///< the same of tissue
  std::vector<double> tissue;                     ///< voxels of each layer
};

Planes planes_across(const LabelImage& labels, unsigned chest_label, unsigned axis) {
  const auto& size = labels.grid.size;
  const std::size_t n = size[axis];
  Planes planes;
  for (auto* list : {&planes.lower, &planes.upper, &planes.tissue_lower, &planes.tissue_upper})
    list->assign(n + 1, 0.);
  planes.tissue.assign(n, 0.);
  const std::array<std::size_t, 3> strides{1, size[0], size[0] * size[1]};
  std::size_t v = 0;
  std::array<std::size_t, 3> index{};
  for (index[2] = 0; index[2] < size[2]; ++index[2])
    for (index[1] = 0; index[1] < size[1]; ++index[1])
      for (index[0] = 0; index[0] < size[0]; ++index[0], ++v) {
        const std::size_t p = index[axis];
        const std::uint8_t here = labels.values[v];
        planes.tissue[p] += here != 0 && here != chest_label;
        if (p == 0)
          continue;
        const std::uint8_t before = labels.values[v - strides[axis]];
        if (here != 0 && before == 0) {
          ++planes.lower[p];
          planes.tissue_lower[p] += here != chest_label;
        } else if (here == 0 && before != 0) {
          ++planes.upper[p];
          planes.tissue_upper[p] += before != chest_label;
        }
      }
  return planes;
}

/// Whether more faces lie in plane p, all at once, than in those beside it.
bool jumps(const std::vector<double>& faces, std::size_t p) {
  return faces[p] > least_jump * std::max(faces[p - 1], faces[p + 1]);
}

} // namespace

std::vector<FlatEnd> flat_ends(const LabelImage& labels, unsigned chest_label) {
  std::vector<FlatEnd> ends;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const Planes planes = planes_across(labels, chest_label, axis);
    const double face = labels.grid.voxel_volume() / labels.grid.spacing[axis];
    double all = 0., before = 0.;
    for (const double layer : planes.tissue)
      all += layer;
    for (std::size_t p = 1; p < labels.grid.size[axis]; ++p) {
      before += planes.tissue[p - 1];
      const double lower = face * planes.tissue_lower[p], upper = face * planes.tissue_upper[p];
      if (lower >= least_area && jumps(planes.lower, p) && before <= most_beyond * all)
        ends.push_back({axis, false, p, lower});
      if (upper >= least_area && jumps(planes.upper, p) && all - before <= most_beyond * all)
        ends.push_back({axis, true, p, upper});
    }
  }
  return ends;
}

LabelImage cropped_to(const LabelImage& labels, const std::vector<FlatEnd>& ends) {
  VoxelBox box{{0, 0, 0}, labels.grid.size};
  for (const FlatEnd& flat : ends)
    if (flat.is_upper)
      box.end[flat.axis] = std::min(box.end[flat.axis], flat.border);
    else
      box.begin[flat.axis] = std::max(box.begin[flat.axis], flat.border);
  return part_of(labels, box);
}

} // namespace prosup::image
