#include "registration/step_limit.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include "box.h"
#include "prosup/mechanics/body/cell_edges.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::registration;
using mechanics::cell_edges;
using mechanics::NodeVector;

constexpr JacobianBounds bounds{0.5, 2.};
const Point<3> size(40., 40., 40.); // mm, in cubes of 10 mm

struct Step {
  std::unique_ptr<Distributed> mesh = make_box(MPI_COMM_WORLD, {4, 4, 4}, size);
  mechanics::Body body{*mesh};
  NodeVector unloaded, step;

  Step() : unloaded(body.vertex_positions()) {
    unloaded.update_ghost_values();
    body.initialize(step);
  }

  /// Moves the nodes near `where` by `y` mm.
  void move(const Point<3>& where, double y) {
    for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
      if ((mechanics::node_value(body.vertex_positions(), node) - where).norm() < 1.)
        step.local_element(3 * node + 1) = y;
  }

  double value_at(const Point<3>& where) const {
    double found = 0.;
    for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
      if ((mechanics::node_value(body.vertex_positions(), node) - where).norm() < 1.)
        found = step.local_element(3 * node + 1);
    return Utilities::MPI::sum(found, MPI_COMM_WORLD);
  }

  std::array<double, 2> range() const {
    NodeVector moved = unloaded;
    moved += step;
    moved.update_ghost_values();
    double smallest = 1e9, largest = -1e9;
    for (const auto& cell : body.cells()) {
      const double J = determinant(cell_edges(cell, body.vertex_positions())) /
                       determinant(cell_edges(cell, moved));
      smallest = std::min(smallest, J);
      largest = std::max(largest, J);
    }
    return {Utilities::MPI::min(smallest, MPI_COMM_WORLD),
            Utilities::MPI::max(largest, MPI_COMM_WORLD)};
  }
};

TEST(StepLimit, LeavesAStepWithinTheBoundsAlone) {
  Step s;
  s.move({20., 20., 20.}, 3.);
  limit_step(s.body, s.unloaded, bounds, s.step);
  EXPECT_EQ(s.value_at({20., 20., 20.}), 3.);
}

TEST(StepLimit, ShortensTheStepOfThoseNodesAlone) {
  Step s;
  s.move({10., 10., 10.}, -9.); // would flatten the cells below to a tenth of their height
  s.move({30., 30., 30.}, 3.);
  EXPECT_GT(s.range()[1], 5.);
  limit_step(s.body, s.unloaded, bounds, s.step);
  EXPECT_LE(s.range()[1], bounds.largest);
  EXPECT_GE(s.range()[0], bounds.smallest);
  EXPECT_EQ(s.value_at({10., 10., 10.}), -4.5);
  EXPECT_EQ(s.value_at({30., 30., 30.}), 3.);
}

TEST(StepLimit, TurnsNoCellInsideOut) {
  Step s;
  s.move({20., 20., 20.}, -50.);
  s.move({10., 20., 20.}, 80.);
  limit_step(s.body, s.unloaded, bounds, s.step);
  EXPECT_LE(s.range()[1], bounds.largest);
  EXPECT_GE(s.range()[0], bounds.smallest);
}

TEST(StepLimit, AllowsWhatIsBeyondTheBoundsToGetBetter) {
  Step s;
  s.move({10., 10., 10.}, -9.);
  s.unloaded += s.step;
  s.unloaded.update_ghost_values();
  s.step = 0.;
  s.move({10., 10., 10.}, 2.);
  limit_step(s.body, s.unloaded, bounds, s.step);
  EXPECT_EQ(s.value_at({10., 10., 10.}), 2.);
}

} // namespace
} // namespace prosup::tests
