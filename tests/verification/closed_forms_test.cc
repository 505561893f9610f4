#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "box.h"
#include "figures.h"
#include "prosup/mechanics/element/internal_force.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

const Point<3> size(30., 20., 25.); // mm
constexpr double mu = 400., nu = 0.4;
const double lambda = lame_parameters(mu, nu).lambda;

/// What a homogeneous deformation x = F X does to a box of irregular tetrahedra.
struct Response {
  Tensor<2, 3> mean_stress; ///< sum_a f_a X_a / V = P, Pa
  Tensor<1, 3> face_force;  ///< sum of f_a over the face at high `face_axis`, g mm/s^2
};

Response deform(const Element& element, const Tensor<2, 3>& F, unsigned face_axis) {
  const auto mesh = make_box(MPI_COMM_WORLD, {4, 3, 3}, size, [](const Point<3>& p) {
    Point<3> moved = p; // inner nodes only
    for (unsigned d = 0; d < 3; ++d)
      moved[d] += 0.8 * std::sin(M_PI * p[0] / size[0]) * std::sin(M_PI * p[1] / size[1]) *
                  std::sin(M_PI * p[2] / size[2]) * std::cos(p[d]);
    return moved;
  });
  const Body body(*mesh, element);
  InternalForce forces(body);
  forces.set_material({lame_parameters(mu, nu)});
  forces.set_reference(body.vertex_positions());
  NodeVector u, f;
  body.initialize(u);
  body.initialize(f);
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    const Tensor<1, 3> X = node_value(body.vertex_positions(), node);
    for (unsigned c = 0; c < 3; ++c)
      u.local_element(3 * node + c) = (F * X - X)[c];
  }
  forces.subtract(u, f);
  const std::vector<bool> on_face = body.nodes_on_boundary({2 * face_axis + 1});
  Response response;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    const Tensor<1, 3> internal = -node_value(f, node);
    response.mean_stress += outer_product(internal, node_value(body.vertex_positions(), node)) /
                            (size[0] * size[1] * size[2]);
    if (on_face[node])
      response.face_force += internal;
  }
  response.mean_stress = Utilities::MPI::sum(response.mean_stress, MPI_COMM_WORLD);
  response.face_force = Utilities::MPI::sum(response.face_force, MPI_COMM_WORLD);
  return response;
}

/// Lateral stretch s of a bar stretched by l, which its free sides leave without
/// stress: mu (s^2 - 1) + lambda ln(l s^2) = 0, increasing in s.
double lateral_stretch(double l) {
  double low = 1e-3, high = 10.;
  for (unsigned i = 0; i < 100; ++i) {
    const double s = 0.5 * (low + high);
    (mu * (s * s - 1.) + lambda * std::log(l * s * s) > 0. ? high : low) = s;
  }
  return 0.5 * (low + high);
}

/// Runs `check` for all elements in both precisions, with what it may be wrong by.
template <typename Check>
void for_all_elements(const Check& check) {
  for (const ElementType type : all_element_types)
    for (const Precision precision : {Precision::double_precision, Precision::single_precision})
      check(Element{type, precision}, precision == Precision::double_precision ? 1e-11 : 1e-4);
}

void tell(const std::string& what, const std::string& against, const Element& element, double error,
          double bound) {
  tell_figure(what + ", " + name_of(element.type) + ", " +
                  precision_names()[static_cast<unsigned>(element.precision)],
              against, format("%.1e relative", error), format("%.0e", bound));
}

TEST(ClosedForms, UniaxialStretch) {
  for_all_elements([](const Element& element, double bound) {
    double largest = 0.;
    for (const double l : {0.6, 0.9, 1.2, 2.}) {
      const double s = lateral_stretch(l);
      Tensor<2, 3> F;
      F[0][0] = l, F[1][1] = F[2][2] = s;
      const double axial = mu * (l - s * s / l); // P, the log eliminated by the side's equation
      const Response response = deform(element, F, 0);
      Tensor<2, 3> expected;
      expected[0][0] = axial;
      const Tensor<1, 3> pull({axial * size[1] * size[2], 0., 0.});
      largest = std::max({largest, (response.mean_stress - expected).norm() / mu,
                          (response.face_force - pull).norm() / (mu * size[1] * size[2])});
    }
    EXPECT_LT(largest, bound) << name_of(element.type);
    tell("uniaxial stretch 0.6 to 2, nu = 0.4", "P = mu (l - s^2/l), stress-free sides", element,
         largest, bound);
  });
}

TEST(ClosedForms, SimpleShear) {
  for_all_elements([](const Element& element, double bound) {
    double largest = 0.;
    for (const double shear : {0.1, 0.5, 1.}) {
      Tensor<2, 3> F;
      F[0][0] = F[1][1] = F[2][2] = 1.;
      F[0][1] = shear;
      Tensor<2, 3> expected; // J = 1
      expected[0][1] = expected[1][0] = mu * shear;
      const Response response = deform(element, F, 1);
      // Along the shear only the face itself pulls; its edges belong to others too.
      const double pull = mu * shear * size[0] * size[2];
      largest = std::max({largest, (response.mean_stress - expected).norm() / mu,
                          std::abs(response.face_force[0] - pull) / (mu * size[0] * size[2])});
    }
    EXPECT_LT(largest, bound) << name_of(element.type);
    tell("simple shear 0.1 to 1, nu = 0.4", "P12 = P21 = mu g, all else 0", element, largest,
         bound);
  });
}

} // namespace
} // namespace prosup::tests
