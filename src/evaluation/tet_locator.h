#ifndef PROSUP_EVALUATION_TET_LOCATOR_H
#define PROSUP_EVALUATION_TET_LOCATOR_H

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace prosup::evaluation {

using dealii::Point;
using dealii::Tensor;

/// Finds the tetrahedron that holds a point, by a uniform grid of bins.
///
/// VTK's vtkStaticCellLocator, which does the same, takes a point for inside when
/// its weights are above -0.001. Beside a face it may answer with the neighbour,
/// so that there and back misses the point by 5e-4 mm on cells of 5 mm, where the
/// map of points is to be exact. It also takes 1.0 microseconds, this one 0.4.
class TetLocator {
public:
  using Cells = std::vector<std::array<unsigned, 4>>;

  struct Hit {
    std::size_t cell;
    std::array<double, 4> weights; ///< barycentric, sum 1
  };

  TetLocator(const std::vector<Point<3>>& nodes, const Cells& cells);

  /// The cell that holds `p` to within 1e-9 mm, if there is one. Flat cells hold
  /// no points.
  std::optional<Hit> find(const Point<3>& p) const;

private:
  /// The weights as affine functions of position: w_a = gradient_a . (x - origin)
  /// for a = 1, 2, 3, and w_0 = 1 - w_1 - w_2 - w_3.
  struct Affine {
    Point<3> origin;
    std::array<Tensor<1, 3>, 3> gradients;
    double tolerance; ///< the weight that stands for 1e-9 mm
  };

  static Affine affine(const std::array<Point<3>, 4>& corners);
  std::array<std::ptrdiff_t, 3> bin_of(const Point<3>& p) const;
  void choose_bins(const std::vector<Point<3>>& nodes, std::size_t n_cells);
  void sort_into_bins(const std::vector<Point<3>>& nodes, const Cells& cells);

  std::vector<Affine> affine_;
  Point<3> low_, high_;
  std::array<std::ptrdiff_t, 3> n_bins_{};
  Tensor<1, 3> bins_per_mm_;
  std::vector<std::size_t> first_in_bin_; ///< into cells_in_bins_, one more than bins
  std::vector<unsigned> cells_in_bins_;
};

} // namespace prosup::evaluation

#endif
