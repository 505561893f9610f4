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

/// t = a (cells/1000)^b ranks^c, a straight line in the logarithms.
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

std::string straight_line(const std::vector<Row>& rows) {
  std::vector<std::vector<double>> matrix;
  std::vector<double> memory;
  for (const Row& row : rows) {
    // Each rank brings its libraries.
    matrix.push_back({static_cast<double>(row.ranks), thousand_cells(row)});
    memory.push_back(row.memory.value_or(0.));
  }
  const std::vector<double> c = least_squares(matrix, memory);
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
    text += "| " + first.group + " | " +
            power_law(rows, several, [](const Row& r) { return Value(r.seconds); }) + " | " +
            power_law(rows, several, [](const Row& r) { return r.mesh_seconds; }) + " | " +
            power_law(rows, several, [](const Row& r) { return r.solve_seconds; }) + " | " +
            straight_line(rows) + " |\n";
  }
  if (text.empty())
    return {};
  return "Fitted to the runs: n thousand cells (of all meshes), r ranks.\n\n"
         "| method | time, s | mesh, s | solve, s | memory, MiB |\n|---|---|---|---|---|\n" +
         text;
}

} // namespace prosup::output
