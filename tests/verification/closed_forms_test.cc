#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "box.h"
#include "figures.h"
#include "prosup/mechanics/body/boundary.h"
#include "prosup/mechanics/element/internal_force.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

const Point<3> size(30., 20., 25.); // mm
constexpr double mu = 400., nu = 0.4;
const double lambda = lame_parameters(mu, nu).lambda;

/// A law whose stress is P = mu s(k) (F - F^-T) + lambda ln J F^-T, with
/// s = 1 + 2 c2 k + 3 c3 k^2 and k = I1 - 3 - 2 ln J.
struct Stiffening {
  double c2, c3;
  Law law;

  double operator()(double k) const { return 1. + 2. * c2 * k + 3. * c3 * k * k; }
};
const std::vector<Stiffening> laws{{0., 0., NeoHookean()}, {0.8, 1.5, Yeoh{{}, 0.8, 1.5}}};

/// What a homogeneous deformation x = F X does to a box of irregular tetrahedra.
struct Response {
  Tensor<2, 3> mean_stress; ///< sum_a f_a X_a / V = P, Pa
  Tensor<1, 3> face_force;  ///< sum of f_a over the face at high `face_axis`, g mm/s^2
};

Response deform(const Element& element, const Law& law, const Tensor<2, 3>& F, unsigned face_axis) {
  const auto mesh = make_box(MPI_COMM_WORLD, {4, 3, 3}, size, [](const Point<3>& p) {
    Point<3> moved = p; // inner nodes only
    for (unsigned d = 0; d < 3; ++d)
      moved[d] += 0.8 * std::sin(M_PI * p[0] / size[0]) * std::sin(M_PI * p[1] / size[1]) *
                  std::sin(M_PI * p[2] / size[2]) * std::cos(p[d]);
    return moved;
  });
  const Body body(*mesh, element);
  InternalForce forces(body);
  forces.set_material({lame_parameters(mu, nu), law});
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
  const std::vector<bool> on_face = nodes_on_boundary(body, {2 * face_axis + 1});
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

/// k of a bar stretched by l along its axis and by t across it.
double strain_measure(double l, double t) {
  return l * l + 2. * t * t - 3. - 2. * std::log(l * t * t);
}

/// Lateral stretch t of a bar stretched by l whose sides are free of stress:
/// mu s(k) (t^2 - 1) + lambda ln(l t^2) = 0, negative for small t and positive for large t.
double lateral_stretch(const Stiffening& s, double l) {
  double low = 1e-3, high = 10.;
  for (unsigned i = 0; i < 100; ++i) {
    const double t = 0.5 * (low + high);
    const double stress =
        mu * s(strain_measure(l, t)) * (t * t - 1.) + lambda * std::log(l * t * t);
    (stress > 0. ? high : low) = t;
  }
  return 0.5 * (low + high);
}

/// Runs `check` for all laws and elements in both precisions, with the error that is allowed.
template <typename Check>
void for_all_laws_and_elements(const Check& check) {
  for (const Stiffening& law : laws)
    for (const ElementType type : all_element_types)
      for (const Precision precision : {Precision::double_precision, Precision::single_precision})
        check(law, Element{type, precision},
              precision == Precision::double_precision ? 1e-11 : 1e-4);
}

void tell(const std::string& what, const std::string& against, const Law& law,
          const Element& element, double error, double bound) {
  tell_figure(what + remark_on(law) + ", " + name_of(element.type) + ", " +
                  precision_names()[static_cast<unsigned>(element.precision)],
              against, format("%.1e relative", error), format("%.0e", bound));
}

TEST(ClosedForms, UniaxialStretch) {
  for_all_laws_and_elements([](const Stiffening& s, const Element& element, double bound) {
    double largest = 0.;
    for (const double l : {0.6, 0.9, 1.2, 2.}) {
      const double t = lateral_stretch(s, l);
      Tensor<2, 3> F;
      F[0][0] = l, F[1][1] = F[2][2] = t;
      // P, with ln J from the equation of the sides.
      const double axial = mu * s(strain_measure(l, t)) * (l - t * t / l);
      const Response response = deform(element, s.law, F, 0);
      Tensor<2, 3> expected;
      expected[0][0] = axial;
      const Tensor<1, 3> pull({axial * size[1] * size[2], 0., 0.});
      largest = std::max({largest, (response.mean_stress - expected).norm() / mu,
                          (response.face_force - pull).norm() / (mu * size[1] * size[2])});
    }
    EXPECT_LT(largest, bound) << name_of(element.type);
    tell("uniaxial stretch 0.6 to 2, nu = 0.4", "P = mu s(k) (l - t^2/l), stress-free sides", s.law,
         element, largest, bound);
  });
}

TEST(ClosedForms, SimpleShear) {
  for_all_laws_and_elements([](const Stiffening& s, const Element& element, double bound) {
    double largest = 0.;
    for (const double shear : {0.1, 0.5, 1.}) {
      Tensor<2, 3> F;
      F[0][0] = F[1][1] = F[2][2] = 1.;
      F[0][1] = shear;
      const double modulus = mu * s(shear * shear); // J = 1
      Tensor<2, 3> expected;
      expected[0][1] = expected[1][0] = modulus * shear;
      const Response response = deform(element, s.law, F, 1);
      // Along the shear only the face itself pulls; its edges belong to others too.
      const double pull = modulus * shear * size[0] * size[2];
      largest = std::max({largest, (response.mean_stress - expected).norm() / mu,
                          std::abs(response.face_force[0] - pull) / (mu * size[0] * size[2])});
    }
    EXPECT_LT(largest, bound) << name_of(element.type);
    tell("simple shear 0.1 to 1, nu = 0.4", "P12 = P21 = mu s(k) g, all else 0", s.law, element,
         largest, bound);
  });
}

} // namespace
} // namespace prosup::tests
