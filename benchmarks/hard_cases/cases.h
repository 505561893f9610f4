#ifndef PROSUP_BENCHMARKS_HARD_CASES_CASES_H
#define PROSUP_BENCHMARKS_HARD_CASES_CASES_H

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "prosup/mesh/tet_mesh.h"
#include "prosup/unloading/unloading_parameters.h"
#include "shapes.h"

namespace prosup::benchmarks {

/// What an unloading comes to.
enum class Outcome {
  settled,           ///< within 0.05 mm of Newton's solution at every node
  no_unloaded_state, ///< said that there is none, and for which part of the weight there is
  not_settled,       ///< stopped at the largest number of steps, and said why
  refused            ///< stopped before the first step
};

/// As it is written in the table.
std::string name_of(Outcome outcome);

/// A body that is hard to unload, and what has to come of it.
struct Case {
  std::string name;
  std::string hardness; ///< what is hard about it, one phrase
  Shape shape = ordinary_breast();
  double shear_modulus = 357.1;           ///< of fat, Pa
  double poisson_ratio = 0.45;            ///< of all tissues
  std::map<unsigned, double> stiffness{}; ///< factor on the shear modulus of other labels
  double gravity = 1.;                    ///< in units of g
  Tensor<1, 3> gravity_direction{{0., -1., 0.}};
  Tensor<2, 3> axes{{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}}; ///< of the image
  double small_edge = 12., full_edge = 5.5;                      ///< mm
  unsigned n_refinements = 0;                                    ///< 8 cells out of one
  std::function<void(mesh::TetMesh&)> edit{};
  std::function<void(unloading::UnloadingParameters&)> settings{};
  Outcome expected = Outcome::settled;
  std::string expected_words{};  ///< which the explanation has to hold
  unsigned expected_retries = 0; ///< at least
};

std::vector<Case> hard_cases();

} // namespace prosup::benchmarks

#endif
