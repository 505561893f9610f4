#include "prosup/prepare/breast_region.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "flood.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::prepare {

namespace {

using image::LabelImage;
using image::VoxelBox;
using image::VoxelGrid;

/// Whether a column of tissue belongs to a breast.
bool is_breast(const Point<3>& p, const TrunkSurface& chest) {
  const TrunkAxis& axis = chest.grid.axis;
  return axis.radius(p) - chest(axis.angle(p), p[2]) > least_breast_thickness;
}

bool is_on_side(const Point<3>& p, const TrunkAxis& axis, Side side) {
  return side == Side::both || (p[0] > axis.x) == (side == Side::left);
}

/// Calls function(i, j, k, point) for the voxels of a breast.
template <typename Function>
void for_each_breast_voxel(const LabelImage& front, const TrunkSurface& chest, Side side,
                           const Function& function) {
  const auto& size = front.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i) {
        if (front(i, j, k) == 0)
          continue;
        const Point<3> p = front.grid.physical(double(i), double(j), double(k));
        if (is_on_side(p, chest.grid.axis, side) && is_breast(p, chest))
          function(i, j, k, p);
      }
}

/// The box of the voxels of a breast; empty if there are none.
VoxelBox tight_box(const LabelImage& front, const TrunkSurface& chest, Side side) {
  VoxelBox box;
  for_each_breast_voxel(
      front, chest, side,
      [&](std::size_t i, std::size_t j, std::size_t k, const Point<3>&) { box.include(i, j, k); });
  return box;
}

/// Adds the margin; behind, the image is kept to its border, for the chest.
VoxelBox with_chest(const VoxelBox& tight, const VoxelGrid& grid, double margin) {
  VoxelBox box = image::with_margin(tight, grid, margin);
  (front_is_first(grid) ? box.end[1] : box.begin[1]) = front_is_first(grid) ? grid.size[1] : 0;
  return box;
}

/// Sections of a breast with planes across an axis of the grid, in voxels.
std::vector<std::size_t> sections(const LabelImage& front, const TrunkSurface& chest, Side side,
                                  unsigned axis) {
  std::vector<std::size_t> n(front.grid.size[axis], 0);
  for_each_breast_voxel(front, chest, side,
                        [&](std::size_t i, std::size_t, std::size_t k, const Point<3>& p) {
                          if (std::abs(chest.grid.axis.angle(p)) < widest_breast)
                            ++n[axis == 0 ? i : k];
                        });
  return n;
}

} // namespace

const std::vector<std::string>& side_names() {
  static const std::vector<std::string> names{"both", "left", "right"};
  return names;
}

VoxelBox breast_box(const LabelImage& front, const TrunkSurface& chest, Side side, double margin) {
  const VoxelBox box = tight_box(front, chest, side);
  if (box.is_empty())
    throw Error(
        format("No breast is found%s: nowhere is there more than %.0f mm of tissue in front "
               "of the chest; choose the other side, or give a scan that shows the breast.",
               side == Side::both   ? ""
               : side == Side::left ? " on the patient's left"
                                    : " on the patient's right",
               least_breast_thickness));
  return side == Side::both ? VoxelBox{{0, 0, 0}, front.grid.size}
                            : with_chest(box, front.grid, margin);
}

CutSection largest_cut(const LabelImage& front, const TrunkSurface& chest, Side side) {
  static constexpr const char* ends[2][2] = {{"on the patient's right", "on the patient's left"},
                                             {"below", "above"}};
  CutSection cut;
  for (const Side breast : {Side::left, Side::right}) {
    if (side != Side::both && side != breast)
      continue;
    for (const unsigned axis : {0u, 2u}) {
      const std::vector<std::size_t> n = sections(front, chest, breast, axis);
      const std::size_t largest = *std::max_element(n.begin(), n.end());
      const bool rises = front.grid.direction[axis][axis] > 0.;
      for (const bool is_last : {false, true}) {
        const std::size_t at_border = is_last ? n.back() : n.front();
        const double share = double(at_border) / std::max(1., double(largest));
        if (share > cut.share)
          cut = {share,
                 double(at_border) * front.grid.voxel_volume() / front.grid.spacing[axis] / 100.,
                 side_names()[std::size_t(breast)].c_str(), ends[axis / 2][is_last == rises]};
      }
    }
  }
  return cut;
}

void require_whole_breast(const CutSection& cut) {
  constexpr double largest_share = 0.7, largest_area = 10.; // cm^2
  if (cut.share > largest_share && cut.area > largest_area)
    throw Error(format("The %s breast is cut off by the border of the image %s, where its section "
                       "of %.0f cm^2 is %.0f %% of its largest one; give a scan with the whole "
                       "breast in its field of view.",
                       cut.side, cut.where, cut.area, 100. * cut.share));
}

double section_in_the_middle(const LabelImage& front, const TrunkSurface& chest, Side side) {
  if (side == Side::both)
    return 0.;
  const TrunkAxis& axis = chest.grid.axis;
  std::map<long, std::size_t> n; // by the voxels from the plane to the patient's left
  for_each_breast_voxel(front, chest, Side::both,
                        [&](std::size_t, std::size_t, std::size_t, const Point<3>& p) {
                          if (std::abs(axis.angle(p)) < widest_breast)
                            ++n[std::lround((p[0] - axis.x) / front.grid.spacing[0])];
                        });
  std::size_t largest = 1;
  for (const auto& [plane, section] : n)
    if (plane == 0 || (plane > 0) == (side == Side::left))
      largest = std::max(largest, section);
  return double(n[0]) / double(largest);
}

void require_two_sides(double middle_share, Side side) {
  constexpr double largest_share = 0.5;
  if (middle_share > largest_share)
    throw Error(format("The plane between left and right, in the middle of the body, cuts through "
                       "a breast where its section is %.0f %% of the largest one, so the scan "
                       "seems to show one breast only; leave '--side %s' out, which keeps the "
                       "whole scan, or give a scan that shows both sides of the chest.",
                       100. * middle_share, side_names()[std::size_t(side)].c_str()));
}

void require_whole_front(const LabelImage& front) {
  constexpr double largest_area = 400.; // mm^2
  const auto& size = front.grid.size;
  const std::size_t j = front_is_first(front.grid) ? 0 : size[1] - 1;
  std::size_t n = 0;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t i = 0; i < size[0]; ++i)
      n += front(i, j, k) != 0;
  const double area = double(n) * front.grid.spacing[0] * front.grid.spacing[2];
  if (area > largest_area)
    throw Error(format("The breast is cut off by the front border of the image, where %.1f cm^2 of "
                       "tissue are; give a scan with the whole breast in its field of view, or "
                       "correct the header if it takes the back of the body for its front.",
                       area / 100.));
}

} // namespace prosup::prepare
