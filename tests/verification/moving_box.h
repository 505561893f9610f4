#ifndef PROSUP_TESTS_VERIFICATION_MOVING_BOX_H
#define PROSUP_TESTS_VERIFICATION_MOVING_BOX_H

#include <cmath>

#include "box.h"
#include "prosup/mechanics/explicit/central_differences.h"

namespace prosup::tests {

/// How the vertices of a box are moved before it is cut loose.
using Distortion = std::function<dealii::Point<3>(const dealii::Point<3>&)>;

/// A box of 20 x 25 x 30 mm, held at its face at high y, of 1 g/cm^3.
struct MovingBox {
  static constexpr double density = 1e-3; // g/mm^3

  MovingBox(const std::vector<unsigned>& n, mechanics::ElementType type, double poisson_ratio,
            const Distortion& distortion = nullptr, MPI_Comm communicator = MPI_COMM_WORLD)
      : material({mechanics::lame_parameters(300., poisson_ratio)}),
        mesh(make_box(communicator, n, {20., 25., 30.}, distortion)),
        body(*mesh, mechanics::Element{type}), forces(body), highest_frequency(body, forces),
        supports(body, {3}) {
    forces.set_material(material);
    forces.set_reference(body.vertex_positions());
    body.initialize(displacement);
    displacement.update_ghost_values();
  }

  mechanics::StableMass mass(double scaled_fraction = 0.) {
    return mechanics::stable_mass(supports, forces, highest_frequency, displacement, density,
                                  scaled_fraction);
  }

  const std::vector<mechanics::LameParameters> material;
  std::unique_ptr<Distributed> mesh;
  mechanics::Body body;
  mechanics::InternalForce forces;
  mechanics::HighestFrequency highest_frequency;
  mechanics::Supports supports;
  mechanics::NodeVector displacement;
};

/// Moves vertices by up to 2 mm, as rough as the mesh.
inline dealii::Point<3> jittered(const dealii::Point<3>& p) {
  dealii::Point<3> moved = p;
  for (unsigned d = 0; d < 3; ++d)
    moved[d] += 2. * std::sin(37. * p[0] + 17. * p[1] + 11. * p[2] + 2. * d);
  return moved;
}

/// Presses the bricks in the middle of the x axis to a sixteenth of their
/// thickness, so that their tetrahedra are slivers and caps, and jitters them.
inline dealii::Point<3> flattened(const dealii::Point<3>& p) {
  const double x = p[0] - 10.;
  const double edge = 10. / 3.; // of the middle third
  dealii::Point<3> moved(10. + (std::abs(x) <= 1.01 * edge ? x / 16. : x), p[1], p[2]);
  for (unsigned d = 1; d < 3; ++d)
    moved[d] += std::sin(3. * p[1] + 1.3 * p[2] + 2. * d);
  return moved;
}

} // namespace prosup::tests

#endif
