#include "body_parts.h"

#include "prosup/image/filters.h"
#include "user_masks.h"

namespace prosup::prepare {

namespace {

using image::LabelImage;
using image::ScalarImage;

constexpr double rind = 5.; // mm, of skin that a mask of the breast may leave out

LabelImage split(const LabelImage& body, const TrunkSurface& chest, double margin) {
  LabelImage parts(body.grid);
  const auto& size = body.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i) {
        if (body(i, j, k) == 0)
          continue;
        const Point<3> p = body.grid.physical(double(i), double(j), double(k));
        const TrunkAxis& axis = chest.grid.axis;
        const bool behind = axis.radius(p) < chest(axis.angle(p), p[2]) - margin;
        parts(i, j, k) = behind ? behind_wall : in_front_of_wall;
      }
  return parts;
}

/// Tissue outside of the mask is chest, but for a rind between it and the air.
void limit_to_breast(LabelImage& parts, const LabelImage& breast) {
  const ScalarImage to_air = image::signed_distance(image::select_labels(parts, {0})),
                    to_breast = image::signed_distance(breast);
  for (std::size_t v = 0; v < parts.values.size(); ++v)
    if (breast.values[v] != 0)
      parts.values[v] = in_front_of_wall;
    else if (parts.values[v] == in_front_of_wall &&
             (double(to_breast.values[v]) > rind || double(to_air.values[v]) > rind))
      parts.values[v] = behind_wall;
}

} // namespace

LabelImage front_and_chest(const LabelImage& body, const TrunkSurface& chest,
                           const UserMasks& masks) {
  LabelImage parts = split(body, chest, masks.chest ? depth_behind_mask : 0.);
  if (masks.breast)
    limit_to_breast(parts, *masks.breast);
  for (std::size_t v = 0; v < parts.values.size(); ++v) {
    if (masks.gland && masks.gland->values[v] != 0)
      parts.values[v] = in_front_of_wall;
    if (masks.chest && masks.chest->values[v] != 0)
      parts.values[v] = behind_wall;
  }
  return parts;
}

} // namespace prosup::prepare
