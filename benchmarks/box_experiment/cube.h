#ifndef PROSUP_BENCHMARKS_BOX_EXPERIMENT_CUBE_H
#define PROSUP_BENCHMARKS_BOX_EXPERIMENT_CUBE_H

#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

#include "prosup/core/units.h"
#include "prosup/mechanics/laws/material.h"
#include "prosup/mechanics/static/quasi_static.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::benchmarks {

/// The experiment of the paper's appendix: a cube of 15 mm, E = 500 Pa, nu =
/// 0.45, held at the face y = 15 mm, under a body force.
struct BoxExperiment {
  double edge = 15.;            ///< mm
  double youngs_modulus = 500.; ///< E, Pa
  double poisson_ratio = 0.45;
  double gravity = standard_gravity; ///< of the body force, mm/s^2
  dealii::Tensor<1, 3> direction{{0., -1., 0.}};

  mechanics::Material material() const;
};

/// The cube as a body of 5 n^3 tetrahedra; boundary id 2 at the face that is held.
/// If `graded`, they are smaller towards the edges of that face, where stress is
/// singular.
mechanics::Body cube_body(const BoxExperiment& box, unsigned n, const mechanics::Element& element,
                          bool graded);

/// The loaded positions of a body, by Newton's method.
mechanics::NodeVector solve_loaded(const BoxExperiment& box, const mechanics::Body& body);

/// Which way a simulation goes.
enum class Direction { load, unload };

/// A body of one rank as a mesh, loaded and unloaded; quadratic elements as
/// their linear cells.
mesh::UnloadedMesh as_mesh(const mechanics::Body& body, const mechanics::NodeVector& loaded,
                           const mechanics::NodeVector& unloaded);

/// The volume of all cells with nodes at `points`, mm^3.
double volume(const mesh::TetMesh& mesh, const std::vector<dealii::Point<3>>& points);

} // namespace prosup::benchmarks

#endif
