#include <gtest/gtest.h>

#include <cmath>

#include "figures.h"
#include "loaded_box.h"
#include "static_box.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

constexpr double edge = 15.; // mm
const LameParameters material = lame_parameters(200., 0.4);

/// A way to the settled state.
struct Settings {
  const char* damping;
  double ramp, scaled_fraction, lag_factor;
};

const Settings all_settings[] = {{"fixed", 0., 0., 2.5},
                                 {"lowest-frequency", 1., 1., 2.5},
                                 {"lowest-frequency", 4., 0.3, 6.},
                                 {"adaptive", 1., 1., 4.}};

double settled_difference(const Body& body, const Settings& settings, const NodeVector& expected) {
  HangingBoxParameters parameters;
  if (body.element().precision == Precision::single_precision) { // forces round at 1e-6 or so
    parameters.residual_tolerance = 5e-5;
    parameters.position_tolerance = 1e-3;
  }
  parameters.damping = settings.damping;
  parameters.damping_rate = 50.;
  parameters.gravity_ramp = settings.ramp;
  parameters.scaled_fraction = settings.scaled_fraction;
  parameters.lag_factor = settings.lag_factor;
  mechanics::Supports supports(body, {3});
  unloading::Unloading unloading(parameters, supports, Tensor<1, 3>({0., -1., 0.}));
  unloading.set_material({material});
  EXPECT_TRUE(unloading.run().converged) << settings.damping;
  return largest_difference(unloading.unloaded(), expected);
}

TEST(Independence, UnloadedStateOfAnyDampingRampAndMass) {
  for (const ElementType type : all_element_types) {
    const unsigned n = type == ElementType::quadratic ? 2 : 4;
    StaticBox box({n, n, n}, {edge, edge, edge}, type, material);
    NodeVector expected = box.body.vertex_positions();
    expected.update_ghost_values();
    EXPECT_TRUE(box.solver.unload(box.body.vertex_positions(), expected).converged);
    const double motion = largest_difference(expected, box.body.vertex_positions());
    EXPECT_GT(motion, 1.);
    for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
      const Body body(*box.mesh, Element{type, precision});
      const bool in_double = precision == Precision::double_precision;
      const double bound = in_double ? 1e-3 : 5e-3; // mm
      double largest = 0.;
      for (const Settings& settings : all_settings)
        largest = std::max(largest, settled_difference(body, settings, expected));
      EXPECT_LT(largest, bound) << name_of(type) << (in_double ? " double" : " single");
      tell_figure("unloading in four ways (damping, ramp, mass scaling, lag), " + name_of(type) +
                      ", " + precision_names()[static_cast<unsigned>(precision)] +
                      format(", moves %.1f mm", motion),
                  "Newton", format("%.1e mm at most", largest), format("%.0e mm", bound));
    }
  }
}

} // namespace
} // namespace prosup::tests
