#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "prosup/core/log.h"
#include "prosup/output/comparison.h"

namespace prosup::output {

namespace {

using Row = ComparisonRow;
using Value = std::optional<double>;

/// Coefficients c that minimise sum_i (sum_j A_ij c_j - y_i)^2.
std::vector<double> least_squares(const std::vector<std::vector<double>>& matrix,
                                  const std::vector<double>& right) {
  const auto n = static_cast<unsigned>(matrix.front().size());
  dealii::FullMatrix<double> normal(n, n);
  dealii::Vector<double> projected(n), solution(n);
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (unsigned j = 0; j < n; ++j) {
      projected[j] += matrix[i][j] * right[i];
      for (unsigned k = 0; k < n; ++k)
        normal(j, k) += matrix[i][j] * matrix[i][k];
    }
  normal.gauss_jordan();
  normal.vmult(solution, projected);
  return {solution.begin(), solution.end()};
}

double thousand_cells(const Row& row) {
  return *row.cells / 1000.;
}

/// a n^b r^c, a straight line in the logarithms.
std::string power_law(const std::vector<Row>& rows, bool several_ranks,
                      Value (*seconds)(const Row&)) {
  std::vector<std::vector<double>> matrix;
  std::vector<double> logarithms;
  for (const Row& row : rows)
    if (const Value time = seconds(row); time && *time > 0.) {
      matrix.push_back({1., std::log(thousand_cells(row))});
      if (several_ranks)
        matrix.back().push_back(std::log(row.ranks));
      logarithms.push_back(std::log(*time));
    }
  if (logarithms.size() < rows.size())
    return "-";
  const std::vector<double> c = least_squares(matrix, logarithms);
  std::string text = format("%.3g n^%.2f", std::exp(c[0]), c[1]);
  return several_ranks ? text + format(" r^%.2f", c[2]) : text;
}

/// c0 + c1 n, where c0 counts `times` of a row.
std::vector<double> straight_line(const std::vector<Row>& rows, double (*times)(const Row&),
                                  double (*value)(const Row&)) {
  std::vector<std::vector<double>> matrix;
  std::vector<double> values;
  for (const Row& row : rows) {
    matrix.push_back({times(row), thousand_cells(row)});
    values.push_back(value(row));
  }
  return least_squares(matrix, values);
}

/// What is neither meshing nor solving: the start of the process, reading and writing.
std::string rest(const std::vector<Row>& rows) {
  const std::vector<double> c = straight_line(
      rows, [](const Row&) { return 1.; },
      [](const Row& r) {
        return r.seconds - r.mesh_seconds.value_or(0.) - r.solve_seconds.value_or(0.);
      });
  return format("%.2f + %.3f n", c[0], c[1]);
}

/// Each rank brings its libraries.
std::string memory(const std::vector<Row>& rows) {
  const std::vector<double> c = straight_line(
      rows, [](const Row& r) { return static_cast<double>(r.ranks); },
      [](const Row& r) { return r.memory.value_or(0.); });
  return format("%.0f r + %.2f n", c[0], c[1]);
}

std::vector<Row> rows_of(const std::vector<Row>& all, const std::string& group) {
  std::vector<Row> rows;
  for (const Row& row : all)
    if (row.group == group && row.status != "failed" && row.cells && *row.cells > 0.)
      rows.push_back(row);
  return rows;
}

} // namespace

std::string cost_models(const std::vector<Row>& all) {
  std::set<std::string> seen;
  std::string text;
  for (const Row& first : all) {
    if (!seen.insert(first.group).second)
      continue;
    const std::vector<Row> rows = rows_of(all, first.group);
    std::set<double> cells;
    std::set<unsigned> ranks;
    for (const Row& row : rows) {
      cells.insert(*row.cells);
      ranks.insert(row.ranks);
    }
    if (cells.size() < 3)
      continue;
    const bool several = ranks.size() > 1;
    text += "| " + first.group + " | " + rest(rows) + " | " +
            power_law(rows, several, [](const Row& r) { return r.mesh_seconds; }) + " | " +
            power_law(rows, several, [](const Row& r) { return r.solve_seconds; }) + " | " +
            memory(rows) + " |\n";
  }
  if (text.empty())
    return {};
  return "Fitted to the runs, with n thousand cells (of all meshes) and r ranks; the time is the "
         "sum of the three.\n\n"
         "| method | rest, s | mesh, s | solve, s | memory, MiB |\n|---|---|---|---|---|\n" +
         text;
}

} // namespace prosup::output
