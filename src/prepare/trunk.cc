#include "prosup/prepare/trunk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace prosup::prepare {

namespace {

constexpr double degree = 3.14159265358979323846 / 180.;
constexpr double widest_angle = 75. * degree;
constexpr double bin = 2.;             // mm
constexpr double share_of_chest = 0.6; // of the largest area
constexpr double depth_of_axis = 120.; // mm
constexpr std::size_t stride = 2;      // enough voxels for the axis

template <typename Function>
void for_some_of(const image::LabelImage& body, const Function& function) {
  const auto& size = body.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; j += stride)
      for (std::size_t i = 0; i < size[0]; i += stride)
        if (body(i, j, k) != 0)
          function(body.grid.physical(double(i), double(j), double(k)));
}

/// y at which the area of the body, seen from the front, reaches a share of the largest.
double front_of_chest(const image::LabelImage& body) {
  std::map<long, std::size_t> area;
  for_some_of(body, [&](const Point<3>& p) { ++area[std::lround(p[1] / bin)]; });
  std::size_t largest = 0;
  for (const auto& plane : area)
    largest = std::max(largest, plane.second);
  const auto front = std::find_if(area.begin(), area.end(), [&](const auto& plane) {
    return double(plane.second) > share_of_chest * double(largest);
  });
  return front == area.end() ? 0. : bin * double(front->first);
}

} // namespace

double TrunkAxis::radius(const Point<3>& p) const {
  return std::hypot(p[0] - x, p[1] - y);
}

double TrunkAxis::angle(const Point<3>& p) const {
  return std::atan2(p[0] - x, y - p[1]);
}

Point<3> TrunkAxis::position(double radius, double angle, double z) const {
  return {x + radius * std::sin(angle), y - radius * std::cos(angle), z};
}

TrunkAxis find_trunk_axis(const image::LabelImage& body) {
  TrunkAxis axis;
  axis.front = front_of_chest(body);
  axis.y = axis.front + depth_of_axis;
  double low = std::numeric_limits<double>::max(), high = -low;
  for_some_of(body, [&](const Point<3>& p) {
    if (p[1] < axis.front)
      return;
    low = std::min(low, p[0]);
    high = std::max(high, p[0]);
  });
  axis.x = low <= high ? 0.5 * (low + high) : 0.;
  return axis;
}

double largest_radius(const image::LabelImage& body, const TrunkAxis& axis) {
  double largest = 0.;
  for_some_of(body, [&](const Point<3>& p) { largest = std::max(largest, axis.radius(p)); });
  return largest;
}

TrunkGrid trunk_grid(const TrunkAxis& axis, const image::VoxelGrid& image, double angle_step,
                     double z_step) {
  double low = std::numeric_limits<double>::max(), high = -low;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto end = [&](unsigned d) {
      return corner & (1u << d) ? double(image.size[d]) - 1. : 0.;
    };
    const double z = image.physical(end(0), end(1), end(2))[2];
    low = std::min(low, z);
    high = std::max(high, z);
  }
  TrunkGrid grid;
  grid.axis = axis;
  grid.angle_step = angle_step;
  const double n_on_a_side = std::floor(widest_angle / angle_step);
  grid.n_columns = 2 * static_cast<std::size_t>(n_on_a_side) + 1;
  grid.first_angle = -angle_step * n_on_a_side;
  grid.n_rows = static_cast<std::size_t>((high - low) / z_step) + 1;
  grid.z_step = z_step;
  grid.first_z = 0.5 * (low + high - z_step * double(grid.n_rows - 1));
  return grid;
}

double TrunkSurface::operator()(double angle, double z) const {
  const auto locate = [](double at, std::size_t n, std::size_t& first) {
    const double clamped = std::clamp(at, 0., double(n - 1));
    first = std::min(static_cast<std::size_t>(clamped), n > 1 ? n - 2 : 0);
    return clamped - double(first);
  };
  std::size_t row = 0, column = 0;
  const double t = locate((z - grid.first_z) / grid.z_step, grid.n_rows, row);
  const double s = locate((angle - grid.first_angle) / grid.angle_step, grid.n_columns, column);
  const auto at = [&](std::size_t r, std::size_t c) {
    return radius[std::min(r, grid.n_rows - 1) * grid.n_columns + std::min(c, grid.n_columns - 1)];
  };
  return (1. - t) * ((1. - s) * at(row, column) + s * at(row, column + 1)) +
         t * ((1. - s) * at(row + 1, column) + s * at(row + 1, column + 1));
}

} // namespace prosup::prepare
