#ifndef PROSUP_BENCHMARKS_BOX_EXPERIMENT_SHADED_H
#define PROSUP_BENCHMARKS_BOX_EXPERIMENT_SHADED_H

#include <deal.II/base/point.h>

#include <array>
#include <filesystem>
#include <vector>

namespace prosup::benchmarks {

/// A body to be shown: its cells, where its nodes are, and the point of the cube
/// that each of them is, after which it is painted in a chequered pattern.
struct Shape {
  const std::vector<std::array<unsigned, 4>>* cells;
  std::vector<dealii::Point<3>> position, material;
};

/// Draws the shapes beside each other at one scale, seen obliquely from below,
/// with y up. @throws Error if the file cannot be written.
void write_shaded(const std::vector<Shape>& shapes, const std::filesystem::path& png);

} // namespace prosup::benchmarks

#endif
