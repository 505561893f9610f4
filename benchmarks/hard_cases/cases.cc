#include "cases.h"

#include <cmath>

#include "mesh_edits.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::benchmarks {

using namespace dealii;
using unloading::UnloadingParameters;

namespace {

const Tensor<1, 3> supine({0., 1., 0.});

Case named(const std::string& name, const std::string& hardness) {
  Case result;
  result.name = name;
  result.hardness = hardness;
  return result;
}

void add_materials(std::vector<Case>& cases) {
  for (const double nu : {0.3, 0.45, 0.49, 0.499}) {
    cases.push_back(named(format("nu-%g", nu), format("Poisson's ratio %g", nu)));
    cases.back().poisson_ratio = nu;
  }
  for (const double mu : {100., 5000.})
    for (const bool is_prone : {true, false}) {
      cases.push_back(named(format("mu-%g-%s", mu, is_prone ? "prone" : "supine"),
                            format("shear modulus %g Pa, %s", mu, is_prone ? "prone" : "supine")));
      cases.back().shear_modulus = mu;
      if (!is_prone) {
        cases.back().gravity_direction = supine;
        cases.back().shape = flat_breast();
      }
    }
  cases.push_back(named("gland", "gland 50 times stiffer than fat"));
  cases.back().shape = with_gland(ordinary_breast());
  cases.back().stiffness = {{3, 50.}};
  for (const bool has_skin : {false, true}) {
    cases.push_back(named(has_skin ? "skin-on" : "skin-off",
                          has_skin ? "cells of 1.5 mm as skin, E = 4 kPa, on fat of 200 Pa"
                                   : "fat of 200 Pa without that skin"));
    cases.back().shear_modulus = 200.;
    if (has_skin) {
      cases.back().edit = [](mesh::TetMesh& mesh) { grow_skin(mesh, 1.5, 4); };
      cases.back().stiffness = {{4, 4000. / 2.9 / 200.}};
    }
  }
}

void add_shapes(std::vector<Case>& cases) {
  cases.push_back(named("flat-supine", "thin flat breast, supine"));
  cases.back().shape = flat_breast();
  cases.back().gravity_direction = supine;
  cases.push_back(named("pendulous", "pendulous breast on a narrow base"));
  cases.back().shape = pendulous_breast();
  cases.push_back(named("slivers", "slivers of aspect 100 put in, 30 where there is room"));
  cases.back().edit = [](mesh::TetMesh& mesh) {
    if (make_slivers(mesh, 100., 30) < 5)
      throw Error("The mesh of the case 'slivers' has no room for slivers.");
  };
  cases.push_back(named("few-cells", "some 200 cells"));
  cases.back().small_edge = cases.back().full_edge = 20.;
  cases.push_back(named("many-cells", "some 500,000 cells"));
  cases.back().small_edge = 11.;
  cases.back().full_edge = 3.7;
  cases.back().n_refinements = 1;
}

void add_loads(std::vector<Case>& cases) {
  cases.push_back(named("no-gravity", "nothing to do"));
  cases.back().gravity = 0.;
  cases.push_back(named("3g", "three times the weight"));
  cases.back().gravity = 3.;
  cases.push_back(named("3g-soft", "three times the weight on 100 Pa"));
  cases.back().gravity = 3.;
  cases.back().shear_modulus = 100.;
  cases.push_back(named("pendulous-soft", "pendulous breast of 20 Pa"));
  cases.back().shape = pendulous_breast();
  cases.back().shear_modulus = 20.;
  cases.back().expected = Outcome::no_unloaded_state;
  cases.push_back(named("tilted-gravity", "gravity at an angle to all axes"));
  cases.back().gravity_direction = Tensor<1, 3>({0.6, -0.7, 0.4});
}

void add_settings(std::vector<Case>& cases) {
  const auto add = [&](const char* name, const char* hardness, Outcome expected,
                       const std::function<void(UnloadingParameters&)>& settings) {
    cases.push_back(named(name, hardness));
    cases.back().settings = settings;
    cases.back().expected = expected;
  };
  add("no-damping", "fixed damping with r/rho = 0", Outcome::refused,
      [](UnloadingParameters& p) { p.damping = "fixed", p.damping_rate = 0.; });
  cases.back().expected_words = "Damping rate";
  add("weak-damping", "fixed damping with r/rho = 1 /s, a thirtieth of what settles best",
      Outcome::settled, [](UnloadingParameters& p) { p.damping = "fixed", p.damping_rate = 1.; });
  add("hardly-any-damping", "fixed damping with r/rho = 0.01 /s, which makes the ramp 100 s long",
      Outcome::not_settled, [](UnloadingParameters& p) {
        p.damping = "fixed", p.damping_rate = 0.01;
        p.max_steps = 2000;
      });
  cases.back().expected_words = "the load was still rising";
  add("absurd-damping", "fixed damping with r/rho = 1e5 /s", Outcome::settled,
      [](UnloadingParameters& p) { p.damping = "fixed", p.damping_rate = 1e5; });
  cases.back().expected_retries = 1;
  add("step-0.99", "time step 0.99 of the critical one", Outcome::settled,
      [](UnloadingParameters& p) { p.step_safety = 0.99, p.scaled_fraction = 0.; });
  add("step-1.2", "time step 1.2 times the critical one", Outcome::settled,
      [](UnloadingParameters& p) { p.step_safety = 1.2, p.scaled_fraction = 0.; });
  cases.back().expected_retries = 1;
  add("correct-every-step", "correction in every step", Outcome::settled,
      [](UnloadingParameters& p) { p.correction_interval = 1; });
  add("full-correction", "full correction in every step, as in the paper", Outcome::settled,
      [](UnloadingParameters& p) { p.correction_interval = 1, p.lag_factor = 0.; });
}

void add_masks(std::vector<Case>& cases) {
  const auto add = [&](const char* name, const char* hardness, Shape shape) {
    cases.push_back(named(name, hardness));
    cases.back().shape = std::move(shape);
  };
  add("two-components", "mask of two components, of which the larger is the body",
      with_far_lump(ordinary_breast()));
  add("holes", "mask with holes of 14 and 3 mm", with_holes(ordinary_breast()));
  add("bridge", "lump on a bridge one voxel thin", with_thin_bridge(ordinary_breast()));
  add("six-faces", "mask that touches all six faces of the image",
      cut_on_all_sides(ordinary_breast()));
  add("oblique", "image with oblique direction cosines", ordinary_breast());
  // The columns of a rotation by 40 degrees about (1, 2, 3).
  const Tensor<1, 3> axis = Tensor<1, 3>({1., 2., 3.}) / std::sqrt(14.);
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (unsigned j = 0; j < 3; ++j) {
    Tensor<1, 3> e;
    e[j] = 1.;
    const Tensor<1, 3> turned =
        c * e + s * cross_product_3d(axis, e) + (1. - c) * (axis * e) * axis;
    for (unsigned i = 0; i < 3; ++i)
      cases.back().axes[i][j] = turned[i];
  }
}

} // namespace

std::string name_of(Outcome outcome) {
  static const char* const names[] = {"settled", "no unloaded state", "not settled", "refused"};
  return names[static_cast<unsigned>(outcome)];
}

std::vector<Case> hard_cases() {
  std::vector<Case> cases;
  add_materials(cases);
  add_shapes(cases);
  add_loads(cases);
  add_settings(cases);
  add_masks(cases);
  return cases;
}

} // namespace prosup::benchmarks
