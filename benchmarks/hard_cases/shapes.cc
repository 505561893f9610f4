#include "shapes.h"

#include <algorithm>
#include <cmath>

#include "prosup/phantom/geometry.h"

namespace prosup::benchmarks {

namespace {

constexpr unsigned air = 0, chest = 1, fat = 2, gland = 3;
constexpr double voxel = 2.; // mm, of all images

phantom::Geometry ordinary_geometry() {
  phantom::Geometry geometry;
  geometry.width = geometry.length = 120.;
  geometry.chest_radius = 110.;
  geometry.height = 60.;
  geometry.sigma = 28.;
  return geometry;
}

/// Tissue of a phantom geometry, and what `is_tissue` adds in front of the chest.
Shape on_chest(const std::string& name, const phantom::Geometry& geometry,
               const std::function<bool(const Point<3>&)>& is_tissue = nullptr, double front = 0.) {
  const double half_width = 0.5 * geometry.width, half_length = 0.5 * geometry.length;
  Shape shape;
  shape.name = name;
  shape.low = {-half_width, std::min(front, geometry.skin_y(0., 0.)) - 8., -half_length};
  shape.high = {half_width, geometry.chest_y(half_width) + 8., half_length};
  shape.label = [=](const Point<3>& x) {
    if (geometry.distance_to_chest(x) < 0.)
      return chest;
    return geometry.in_tissue(x) || (is_tissue && is_tissue(x)) ? fat : air;
  };
  return shape;
}

/// Puts `label` where `is_inside`, if what is there is one of the labels given.
template <class IsInside>
Shape changed(Shape shape, const std::string& name, unsigned from, unsigned to,
              const IsInside& is_inside) {
  shape.name += name;
  shape.label = [label = shape.label, from, to, is_inside](const Point<3>& x) {
    const unsigned present = label(x);
    return present == from && is_inside(x) ? to : present;
  };
  return shape;
}

const Point<3> lump_centre( // of a voxel too
    45., -44., 41.);
constexpr double lump_radius = 11.;

} // namespace

image::LabelImage Shape::image(double spacing, const Tensor<2, 3>& axes) const {
  image::VoxelGrid grid;
  for (unsigned d = 0; d < 3; ++d) {
    grid.size[d] = static_cast<std::size_t>(std::lround((high[d] - low[d]) / spacing));
    grid.spacing[d] = (high[d] - low[d]) / static_cast<double>(grid.size[d]);
    grid.origin[d] = low[d] + 0.5 * grid.spacing[d];
  }
  const image::VoxelGrid upright = grid;
  grid.direction = axes;
  grid.origin = Point<3>(axes * grid.origin);
  image::LabelImage result(grid);
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        result(i, j, k) = static_cast<std::uint8_t>(label(upright.physical(i, j, k)));
  return result;
}

Shape ordinary_breast() {
  return on_chest("ordinary", ordinary_geometry());
}

Shape flat_breast() {
  phantom::Geometry geometry = ordinary_geometry();
  geometry.width = 140.;
  geometry.height = 18.;
  geometry.sigma = 36.;
  return on_chest("flat", geometry);
}

Shape pendulous_breast() {
  phantom::Geometry geometry = ordinary_geometry();
  geometry.height = 0.;
  constexpr double neck = 26., ball = 38., depth = 62.; // mm
  return on_chest(
      "pendulous", geometry,
      [](const Point<3>& x) {
        const bool in_neck = std::hypot(x[0], x[2]) < neck && x[1] > -depth;
        return in_neck || x.distance(Point<3>(0., -depth, 0.)) < ball;
      },
      -depth - ball);
}

Shape with_gland(Shape shape) {
  const Point<3> middle(4., 0.45 * shape.low[1], -3.);
  return changed(std::move(shape), " with gland", fat, gland,
                 [=](const Point<3>& x) { return x.distance(middle) < 16.; });
}

Shape with_far_lump(Shape shape) {
  return changed(std::move(shape), " and a lump", air, fat,
                 [](const Point<3>& x) { return x.distance(lump_centre) < lump_radius; });
}

Shape with_thin_bridge(Shape shape) {
  return changed(with_far_lump(std::move(shape)), " on a bridge", air, fat, [](const Point<3>& x) {
    return std::abs(x[0] - lump_centre[0]) < 0.5 * voxel &&
           std::abs(x[2] - lump_centre[2]) < 0.5 * voxel && x[1] > lump_centre[1];
  });
}

Shape with_holes(Shape shape) {
  return changed(std::move(shape), " with holes", fat, air, [](const Point<3>& x) {
    return x.distance(Point<3>(0., -30., 0.)) < 7. || x.distance(Point<3>(14., -12., 9.)) < 1.5;
  });
}

Shape cut_on_all_sides(Shape shape) {
  shape.name += " cut on all sides";
  shape.low[1] = -40.;
  shape.high[1] = 6.;
  return shape;
}

} // namespace prosup::benchmarks
