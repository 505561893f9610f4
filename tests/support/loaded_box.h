#ifndef PROSUP_TESTS_LOADED_BOX_H
#define PROSUP_TESTS_LOADED_BOX_H

#include <gtest/gtest.h>

#include "box.h"
#include "prosup/mechanics/laws/material.h"
#include "prosup/unloading/unloading.h"

namespace prosup::tests {

using dealii::Point;
using dealii::Tensor;

/// Parameters with tolerances that leave no doubt.
struct HangingBoxParameters : unloading::UnloadingParameters {
  HangingBoxParameters() {
    residual_tolerance = 1e-6;
    position_tolerance = 1e-4;
    damping_rate = 40.;
    max_steps = 200000;
  }
};

/// Corners of each cell of a box before and after a forward simulation under
/// gravity; keyed by cell, so that it does not depend on the ranks.
struct LoadedBox {
  std::vector<std::array<Point<3>, 4>> before, after;

  LoadedBox(const std::vector<unsigned>& n, const Point<3>& size,
            const mechanics::Material& material, const unloading::UnloadingParameters& parameters,
            const Tensor<1, 3>& gravity) {
    // On one rank each: the forward simulation is not what is distributed here.
    const auto mesh = make_box(MPI_COMM_SELF, n, size);
    const mechanics::Body body(*mesh);
    mechanics::Supports supports(body, {3});
    unloading::Unloading loading(parameters, supports, gravity);
    loading.hold_reference();
    loading.set_material(material);
    EXPECT_TRUE(loading.run().converged);
    mechanics::NodeVector x = loading.displacement();
    x += body.vertex_positions();
    x.update_ghost_values();
    before = body.gather_at_cells(body.vertex_positions());
    after = body.gather_at_cells(x);
  }

  /// Loaded position of a vertex.
  Point<3> operator()(const Point<3>& X) const { return partner(before, after, X, 1e-6); }

  /// Unloaded position of a vertex.
  Point<3> unloaded(const Point<3>& x) const { return partner(after, before, x, 1e-6); }

private:
  static Point<3> partner(const std::vector<std::array<Point<3>, 4>>& from,
                          const std::vector<std::array<Point<3>, 4>>& to, const Point<3>& position,
                          double tolerance) {
    for (std::size_t cell = 0; cell < from.size(); ++cell)
      for (unsigned a = 0; a < 4; ++a)
        if (from[cell][a].distance(position) < tolerance)
          return to[cell][a];
    ADD_FAILURE() << "no such vertex: " << position;
    return position;
  }
};

} // namespace prosup::tests

#endif
