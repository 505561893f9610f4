#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "all_laws.h"
#include "box.h"
#include "prosup/mechanics/body/boundary.h"
#include "prosup/mechanics/element/internal_force.h"
#include "prosup/mechanics/explicit/critical_step.h"
#include "strain_energy.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

const std::vector<Element> double_elements{
    {ElementType::linear, Precision::double_precision},
    {ElementType::nodal_pressure, Precision::double_precision},
    {ElementType::quadratic, Precision::double_precision}};

/// Calls check(element, law) for all of both.
template <typename Check>
void for_all_elements_and_laws(const Check& check) {
  for (const Element& element : double_elements)
    for (const Law& law : all_laws()) {
      SCOPED_TRACE(name_of(law));
      check(element, law);
    }
}

std::string name(const Element& element) {
  return element_names()[static_cast<unsigned>(element.type)];
}

/// A skewed box with two materials, its forces, and its energy computed with
/// deal.II's own shape functions.
struct Block {
  Element element;
  std::unique_ptr<Distributed> mesh;
  Body body;
  InternalForce kernel;
  Material material;

  explicit Block(const Element& choice, const Law& law = NeoHookean())
      : element(choice),
        mesh(make_box(MPI_COMM_WORLD, {3, 4, 3}, {30., 40., 35.},
                      [](const Point<3>& p) {
                        return p + Tensor<1, 3>({2. * std::sin(0.1 * p[1]), std::cos(0.1 * p[2]),
                                                 0.05 * p[0]});
                      })),
        body(*mesh, choice), kernel(body) {
    std::vector<LameParameters> of_elements;
    for (unsigned e = 0; e < body.n_elements(); ++e) {
      const Tensor<1, 3> corner = node_value(body.vertex_positions(), body.element_nodes(e)[0]);
      of_elements.push_back(lame_parameters(corner[1] > 18. ? 300. : 900., 0.45));
    }
    material = {of_elements, law};
    kernel.set_material(material);
    kernel.set_reference(body.vertex_positions());
  }

  template <typename Function>
  NodeVector field(Function function) const {
    NodeVector values;
    body.initialize(values);
    for (unsigned node = 0; node < body.n_local_nodes(); ++node) {
      const Tensor<1, 3> value = function(node_value(body.vertex_positions(), node));
      for (unsigned c = 0; c < 3; ++c)
        values.local_element(3 * node + c) = value[c];
    }
    return values;
  }

  NodeVector force(const NodeVector& displacement) const {
    NodeVector result;
    body.initialize(result);
    kernel.subtract(displacement, result);
    result *= -1.;
    return result;
  }

  double energy(const NodeVector& u) const {
    return strain_energy(body, material, body.vertex_positions(), u);
  }
};

Tensor<1, 3> wave(const Tensor<1, 3>& X) {
  return Tensor<1, 3>({2. * std::sin(0.1 * X[1]), 3. * std::cos(0.08 * X[2] + 0.05 * X[0]),
                       2.5 * std::sin(0.07 * X[0] + 0.1 * X[2])});
}

Tensor<1, 3> other_wave(const Tensor<1, 3>& X) {
  return Tensor<1, 3>({std::cos(0.2 * X[0]), std::sin(0.15 * X[1] - 0.1 * X[2]), 0.02 * X[1]});
}

TEST(Elements, ForceIsTheDerivativeOfTheEnergy) {
  for_all_elements_and_laws([](const Element& element, const Law& law) {
    const Block block(element, law);
    const NodeVector u = block.field(wave), direction = block.field(other_wave);
    const double step = 1e-4;
    NodeVector up = u, down = u;
    up.add(step, direction);
    down.add(-step, direction);
    up.update_ghost_values();
    down.update_ghost_values();
    const double slope = (block.energy(up) - block.energy(down)) / (2. * step);
    EXPECT_NEAR(block.force(u) * direction / slope, 1., 1e-6) << name(element);
  });
}

// The largest eigenvalue of the tangent with unit masses comes from the forces alone.
TEST(Elements, StiffnessBoundIsAboveTheLargestStiffness) {
  for_all_elements_and_laws([](const Element& element, const Law& law) {
    const Block block(element, law);
    const unsigned n = block.body.n_local_nodes();
    HighestFrequency frequency(block.body, block.kernel);
    for (const double amplitude : {0., 1.}) {
      NodeVector u = block.field(wave);
      u *= amplitude;
      u.update_ghost_values();
      const double largest =
          frequency.estimate(u, std::vector<double>(n, 1.), std::vector<bool>(n, false)).ritz_value;
      const std::vector<double> bounds = block.kernel.stiffness_bound(u);
      const double bound = *std::max_element(bounds.begin(), bounds.end());
      EXPECT_LT(largest, Utilities::MPI::max(bound, block.body.communicator())) << name(element);
    }
  });
}

TEST(Elements, StiffnessBoundAtRestIsThatOfLinearElasticity) {
  for_all_elements_and_laws([](const Element& element, const Law& law) {
    const Block block(element, law), neo_hookean(element);
    const NodeVector rest = block.field([](const Tensor<1, 3>&) { return Tensor<1, 3>(); });
    const std::vector<double> bounds = block.kernel.stiffness_bound(rest),
                              expected = neo_hookean.kernel.stiffness_bound(rest);
    for (unsigned node = 0; node < bounds.size(); ++node)
      EXPECT_NEAR(bounds[node], expected[node], 1e-10 * expected[node]) << name(element);
  });
}

TEST(Elements, OneMaterialIsTheSameAsOneForEachElement) {
  for (const Element& element : double_elements) {
    Block block(element);
    const NodeVector u = block.field(wave);
    const LameParameters one = lame_parameters(500., 0.4);
    block.kernel.set_material(std::vector<LameParameters>(block.body.n_elements(), one));
    const NodeVector each = block.force(u);
    block.kernel.set_material(one);
    NodeVector difference = block.force(u);
    difference -= each;
    EXPECT_LT(difference.l2_norm(), 1e-12 * each.l2_norm()) << name(element);
  }
}

TEST(Elements, SinglePrecisionAgreesWithDouble) {
  for_all_elements_and_laws([](Element element, const Law& law) {
    const Block in_double(element, law);
    element.precision = Precision::single_precision;
    const Block in_single(element, law);
    const NodeVector force = in_double.force(in_double.field(wave));
    NodeVector difference = in_single.force(in_single.field(wave));
    difference -= force;
    EXPECT_LT(difference.l2_norm(), 1e-5 * force.l2_norm()) << name(element);
    EXPECT_GT(difference.l2_norm(), 0.) << name(element);
  });
}

TEST(Elements, RigidRotationGivesNoForce) {
  const double angle = 0.7;
  const auto rotation = [&](const Tensor<1, 3>& X) {
    return Tensor<1, 3>({std::cos(angle) * X[0] - std::sin(angle) * X[1] - X[0] + 5.,
                         std::sin(angle) * X[0] + std::cos(angle) * X[1] - X[1] - 3., 2.});
  };
  for_all_elements_and_laws([&](const Element& element, const Law& law) {
    const Block block(element, law);
    const double scale = block.force(block.field(wave)).linfty_norm();
    EXPECT_LT(block.force(block.field(rotation)).linfty_norm(), 1e-11 * scale) << name(element);
  });
}

// A homogeneous deformation of one material is in balance: no force inside, and
// at the boundary that of the constant stress.
TEST(Elements, PatchTest) {
  Tensor<2, 3> H;
  H[0][0] = 0.1, H[0][1] = 0.2, H[1][1] = -0.15, H[1][2] = 0.1, H[2][2] = 0.05;
  for (const Element& element : double_elements) {
    Block block(element);
    block.kernel.set_material({lame_parameters(500., 0.45)});
    const NodeVector force = block.force(block.field([&](const Tensor<1, 3>& X) { return H * X; }));
    const std::vector<bool> boundary = nodes_on_boundary(block.body, {0, 1, 2, 3, 4, 5});
    double inside = 0.;
    unsigned n_inside = 0;
    for (unsigned node = 0; node < block.body.n_owned_nodes(); ++node)
      if (!boundary[node]) {
        inside = std::max(inside, node_value(force, node).norm());
        ++n_inside;
      }
    EXPECT_GT(Utilities::MPI::sum(n_inside, MPI_COMM_WORLD), 0u);
    EXPECT_LT(inside, 1e-11 * force.linfty_norm()) << name(element);
  }
}

TEST(Elements, VolumesAndMasses) {
  for (const Element& element : double_elements) {
    const Block block(element);
    const NodeVector none = block.field([](const Tensor<1, 3>&) { return Tensor<1, 3>(); });
    double weight = 0., mass = 0., least_mass = 1e30;
    const std::vector<double> nodal = block.kernel.nodal_volume(),
                              lumped = block.kernel.lumped_volume();
    for (unsigned node = 0; node < block.body.n_owned_nodes(); ++node) {
      weight += nodal[node];
      mass += lumped[node];
      least_mass = std::min(least_mass, lumped[node]);
    }
    weight = Utilities::MPI::sum(weight, MPI_COMM_WORLD);
    EXPECT_NEAR(Utilities::MPI::sum(mass, MPI_COMM_WORLD), weight, 1e-9 * weight) << name(element);
    EXPECT_GT(least_mass, 0.) << name(element);
    // The transform shears and waves, but keeps the height along z times area.
    EXPECT_NEAR(weight, 42000., 300.) << name(element);
  }
}

} // namespace
} // namespace prosup::tests
