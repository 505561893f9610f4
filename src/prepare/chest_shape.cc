#include "chest_shape.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace prosup::prepare {

namespace {

constexpr unsigned angle_degree = 6, z_degree = 3;
constexpr unsigned n_terms = (angle_degree + 1) * (z_degree + 1);
constexpr unsigned n_mean_rounds = 20, n_rounds = 40;
constexpr double smallest_residual = 1.; // mm
constexpr double tukey_width = 15.;      // mm

using Terms = std::array<double, n_terms>;

/// Legendre polynomials of `x` in -1 ... 1, up to `degree`.
void legendre(double x, unsigned degree, double* values) {
  values[0] = 1.;
  if (degree > 0)
    values[1] = x;
  for (unsigned n = 1; n < degree; ++n)
    values[n + 1] = (double(2 * n + 1) * x * values[n] - double(n) * values[n - 1]) / double(n + 1);
}

Terms terms(const TrunkGrid& grid, std::size_t row, std::size_t column) {
  std::array<double, angle_degree + 1> of_angle;
  std::array<double, z_degree + 1> of_z;
  legendre(std::clamp(grid.angle(column) / widest_breast, -1., 1.), angle_degree, of_angle.data());
  const double middle = 0.5 * double(grid.n_rows - 1);
  legendre(middle > 0. ? double(row) / middle - 1. : 0., z_degree, of_z.data());
  Terms result;
  for (unsigned a = 0, t = 0; a <= angle_degree; ++a)
    for (unsigned z = 0; z <= z_degree; ++z, ++t)
      result[t] = of_angle[a] * of_z[z];
  return result;
}

double sum(const Terms& terms, const dealii::Vector<double>& coefficients) {
  double value = 0.;
  for (unsigned t = 0; t < n_terms; ++t)
    value += terms[t] * coefficients[t];
  return value;
}

double weight(double residual, unsigned round) {
  if (round == 0)
    return 1.;
  if (round <= n_mean_rounds)
    return 1. / std::max(std::abs(residual), smallest_residual);
  const double ratio = residual / tukey_width;
  return std::abs(ratio) < 1. ? (1. - ratio * ratio) * (1. - ratio * ratio) : 0.;
}

/// The coefficients with which the weighted squares of the residuals are least.
dealii::Vector<double> fitted(const std::vector<Terms>& basis, const std::vector<double>& radius,
                              const std::vector<double>& weights) {
  dealii::FullMatrix<double> matrix(n_terms, n_terms);
  dealii::Vector<double> right(n_terms), coefficients(n_terms);
  for (std::size_t i = 0; i < basis.size(); ++i)
    for (unsigned s = 0; s < n_terms; ++s) {
      right[s] += weights[i] * basis[i][s] * radius[i];
      for (unsigned t = 0; t < n_terms; ++t)
        matrix(s, t) += weights[i] * basis[i][s] * basis[i][t];
    }
  // Terms that nothing tells of, as where a scan shows few angles, stay 0.
  for (unsigned t = 0; t < n_terms; ++t)
    matrix(t, t) += 1e-4 * double(basis.size() + 1) / double(n_terms);
  matrix.gauss_jordan();
  matrix.vmult(coefficients, right);
  return coefficients;
}

constexpr int steps[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};

/// Calls `function(row, column)` for the neighbours of a column.
template <typename Function>
void for_neighbours(const ColumnMap& map, std::size_t row, std::size_t column,
                    const Function& function) {
  for (const auto& step : steps) {
    const std::size_t r = row + std::size_t(step[0]), c = column + std::size_t(step[1]);
    if (r < map.n_rows && c < map.n_columns) // wraps around below 0
      function(r, c);
  }
}

} // namespace

ColumnMap smooth_chest(const TrunkGrid& grid, const ColumnMap& radius,
                       const std::vector<char>& counts) {
  std::vector<Terms> basis;
  std::vector<double> of_counted;
  double mean = 0.;
  for (std::size_t r = 0, at = 0; r < grid.n_rows; ++r)
    for (std::size_t c = 0; c < grid.n_columns; ++c, ++at)
      if (counts[at] != 0) {
        basis.push_back(terms(grid, r, c));
        of_counted.push_back(radius.values[at]);
        mean += radius.values[at];
      }
  mean /= double(std::max<std::size_t>(1, basis.size()));
  for (double& value : of_counted)
    value -= mean;
  dealii::Vector<double> coefficients(n_terms);
  std::vector<double> weights(basis.size());
  for (unsigned round = 0; round < n_rounds; ++round) {
    for (std::size_t i = 0; i < basis.size(); ++i)
      weights[i] = weight(of_counted[i] - sum(basis[i], coefficients), round);
    coefficients = fitted(basis, of_counted, weights);
  }
  ColumnMap smooth(grid.n_rows, grid.n_columns);
  for (std::size_t r = 0; r < grid.n_rows; ++r)
    for (std::size_t c = 0; c < grid.n_columns; ++c)
      smooth(r, c) = mean + sum(terms(grid, r, c), coefficients);
  return smooth;
}

ColumnMap hill_height(const ColumnMap& height, const std::vector<char>& counts) {
  // The largest of the lowest heights of all paths to a border, as distances are found by Dijkstra.
  ColumnMap pass(height.n_rows, height.n_columns, std::numeric_limits<double>::lowest());
  std::priority_queue<std::tuple<double, std::size_t, std::size_t>> front;
  const auto reach = [&](std::size_t r, std::size_t c, double level) {
    if (level <= pass(r, c))
      return;
    pass(r, c) = level;
    front.emplace(level, r, c);
  };
  for (std::size_t r = 0, at = 0; r < height.n_rows; ++r)
    for (std::size_t c = 0; c < height.n_columns; ++c, ++at) {
      if (counts[at] == 0)
        continue;
      unsigned n_counted = 0;
      for_neighbours(height, r, c, [&](std::size_t i, std::size_t j) {
        n_counted += counts[i * height.n_columns + j] != 0;
      });
      if (n_counted < 4)
        reach(r, c, height(r, c));
    }
  while (!front.empty()) {
    const auto top = front.top();
    front.pop();
    const double level = std::get<0>(top);
    const std::size_t r = std::get<1>(top), c = std::get<2>(top);
    if (level == pass(r, c))
      for_neighbours(height, r, c, [&](std::size_t i, std::size_t j) {
        if (counts[i * height.n_columns + j] != 0)
          reach(i, j, std::min(level, height(i, j)));
      });
  }
  ColumnMap hill(height.n_rows, height.n_columns);
  for (std::size_t at = 0; at < counts.size(); ++at)
    hill.values[at] = counts[at] != 0 ? height.values[at] - pass.values[at] : 0.;
  return hill;
}

std::vector<char> hills(const ColumnMap& hill_height, double lowest, double highest) {
  std::vector<char> found(hill_height.values.size(), 0);
  std::vector<std::pair<std::size_t, std::size_t>> front;
  const auto reach = [&](std::size_t r, std::size_t c, double least) {
    const std::size_t at = r * hill_height.n_columns + c;
    if (found[at] == 0 && hill_height.values[at] >= least) {
      found[at] = 1;
      front.emplace_back(r, c);
    }
  };
  for (std::size_t r = 0; r < hill_height.n_rows; ++r)
    for (std::size_t c = 0; c < hill_height.n_columns; ++c)
      reach(r, c, highest);
  while (!front.empty()) {
    const auto [r, c] = front.back();
    front.pop_back();
    for_neighbours(hill_height, r, c, [&](std::size_t i, std::size_t j) { reach(i, j, lowest); });
  }
  return found;
}

void bridge(ColumnMap& map, const std::vector<char>& unknown) {
  constexpr unsigned n_rounds_of_membrane = 300;
  for (unsigned round = 0; round < n_rounds_of_membrane; ++round)
    for (std::size_t r = 0; r < map.n_rows; ++r)
      for (std::size_t c = 0; c < map.n_columns; ++c) {
        if (unknown[r * map.n_columns + c] == 0)
          continue;
        double sum_of_neighbours = 0., n = 0.;
        for_neighbours(map, r, c, [&](std::size_t i, std::size_t j) {
          sum_of_neighbours += map(i, j);
          n += 1.;
        });
        if (n > 0.)
          map(r, c) = sum_of_neighbours / n;
      }
}

} // namespace prosup::prepare
