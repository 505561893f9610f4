#ifndef PROSUP_TESTS_STATIC_BOX_H
#define PROSUP_TESTS_STATIC_BOX_H

#include "box.h"
#include "prosup/mechanics/body/boundary.h"
#include "prosup/mechanics/static/quasi_static.h"

namespace prosup::tests {

/// A box of 1 g/cm^3 that hangs from its face at high y, with its Newton solver.
struct StaticBox {
  StaticBox(const std::vector<unsigned>& n, const dealii::Point<3>& size,
            mechanics::ElementType type, const mechanics::Material& material,
            const std::string& linear_algebra = "", MPI_Comm communicator = MPI_COMM_WORLD)
      : mesh(make_box(communicator, n, size)), body(*mesh, mechanics::Element{type}),
        solver(parameters, body) {
    if (!linear_algebra.empty())
      parameters.linear_algebra = linear_algebra;
    solver.set_material(material);
    solver.set_fixed_nodes(nodes_on_boundary(body, {3}));
    solver.set_body_force(dealii::Tensor<1, 3>({0., -9.81, 0.})); // g/(mm^2 s^2)
    body.initialize(displacement);
    displacement.update_ghost_values();
  }

  mechanics::QuasiStaticResult load() { return solver.load(body.vertex_positions(), displacement); }

  mechanics::NodeVector loaded() const {
    mechanics::NodeVector x;
    body.initialize(x);
    for (unsigned i = 0; i < x.locally_owned_size(); ++i)
      x.local_element(i) = body.vertex_positions().local_element(i) + displacement.local_element(i);
    x.update_ghost_values();
    return x;
  }

  mechanics::QuasiStaticParameters parameters;
  std::unique_ptr<Distributed> mesh;
  mechanics::Body body;
  mechanics::QuasiStatic solver;
  mechanics::NodeVector displacement;
};

/// Largest component of a - b over the ranks.
inline double largest_difference(const mechanics::NodeVector& a, const mechanics::NodeVector& b) {
  double largest = 0.;
  for (unsigned i = 0; i < a.locally_owned_size(); ++i)
    largest = std::max(largest, std::abs(a.local_element(i) - b.local_element(i)));
  return dealii::Utilities::MPI::max(largest, a.get_mpi_communicator());
}

} // namespace prosup::tests

#endif
