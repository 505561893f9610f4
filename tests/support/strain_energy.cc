#include "strain_energy.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <cmath>
#include <vector>

#include "prosup/mechanics/laws/stress.h"

namespace prosup::tests {

using namespace dealii;
using mechanics::node_value;

namespace {

/// The centroid rule, and that of four points (Keast): deal.II 9.4 has the latter
/// to four digits only.
Quadrature<3> quadrature_of_degree(unsigned degree) {
  if (degree == 1)
    return Quadrature<3>({Point<3>(0.25, 0.25, 0.25)}, {1. / 6.});
  const double a = 0.25 + 0.15 * std::sqrt(5.), b = 0.25 - 0.05 * std::sqrt(5.);
  return Quadrature<3>({{b, b, b}, {a, b, b}, {b, a, b}, {b, b, a}},
                       {1. / 24., 1. / 24., 1. / 24., 1. / 24.});
}

} // namespace

double strain_energy(const mechanics::Body& body, const mechanics::Material& material,
                     const mechanics::NodeVector& reference, const mechanics::NodeVector& u) {
  const FE_SimplexP<3> shape(body.element().degree());
  const Quadrature<3> quadrature = quadrature_of_degree(body.element().degree());
  const bool averaged = body.element().type == mechanics::ElementType::nodal_pressure;
  std::vector<double> V(body.n_local_nodes(), 0.), VJ = V, Vlambda = V;
  double sum = 0.;
  for (unsigned e = 0; e < body.n_elements(); ++e)
    for (unsigned q = 0; q < quadrature.size(); ++q) {
      Tensor<2, 3> D, H;
      for (unsigned a = 0; a < shape.n_dofs_per_cell(); ++a) {
        const unsigned node = body.element_nodes(e)[a];
        const Tensor<1, 3> gradient = shape.shape_grad(a, quadrature.point(q));
        D += outer_product(node_value(reference, node), gradient);
        H += outer_product(node_value(u, node), gradient);
      }
      Tensor<2, 3> F = H * invert(D);
      for (unsigned c = 0; c < 3; ++c)
        F[c][c] += 1.;
      const double volume = quadrature.weight(q) * determinant(D), J = determinant(F);
      const mechanics::LameParameters m = material[e];
      sum +=
          volume * mechanics::energy_density(F, {m.mu, averaged ? 0. : m.lambda}, material.law());
      for (unsigned a = 0; a < 4; ++a) {
        const unsigned node = body.element_nodes(e)[a];
        V[node] += volume / 4.;
        VJ[node] += volume * J / 4.;
        Vlambda[node] += volume * m.lambda / 4.;
      }
    }
  if (averaged) {
    V = sum_over_ranks(body, V);
    VJ = sum_over_ranks(body, VJ);
    Vlambda = sum_over_ranks(body, Vlambda);
    const auto add_volumetric = [&](const auto& law) {
      for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
        sum += law.volume_energy(Vlambda[node], std::log(VJ[node] / V[node]));
    };
    std::visit(add_volumetric, material.law());
  }
  return Utilities::MPI::sum(sum, body.communicator());
}

} // namespace prosup::tests
