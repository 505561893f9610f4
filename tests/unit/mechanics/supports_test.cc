#include "prosup/mechanics/body/supports.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "box.h"
#include "prosup/mechanics/static/support_force.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

/// Spheres about a centre.
class Spheres : public Surface {
public:
  explicit Spheres(const Point<3>& centre) : centre_(centre) {}
  double distance(const Tensor<1, 3>& x, Tensor<1, 3>& normal) const override {
    normal = x - centre_;
    const double radius = normal.norm();
    normal /= radius;
    return radius;
  }

private:
  const Point<3> centre_;
};

const Point<3> size({20., 20., 20.});

/// A box that slides on spheres below its face at low y and has springs there.
struct SupportedBox {
  explicit SupportedBox(ContactLaw law = ContactLaw::tied)
      : mesh(make_box(MPI_COMM_WORLD, {3, 3, 3}, size)), body(*mesh), supports(body) {
    supports.slide_on(std::make_shared<Spheres>(Point<3>(10., -60., 10.)), {2}, law);
    supports.add_springs({2}, 8.);
    for (NodeVector* vector : {&unloaded, &u, &v, &f})
      body.initialize(*vector);
    unloaded = body.vertex_positions();
    unloaded.update_ghost_values();
    supports.set_reference(unloaded);
  }

  void shake() {
    for (unsigned i = 0; i < 3 * body.n_owned_nodes(); ++i) {
      const double phase = 3.7 * body.vertex_positions().local_element(i) + i % 3;
      u.local_element(i) = 0.2 * std::sin(phase);
      v.local_element(i) = std::cos(phase);
      f.local_element(i) = std::sin(2. * phase);
    }
    u.update_ghost_values();
  }

  std::unique_ptr<Distributed> mesh;
  Body body;
  Supports supports;
  NodeVector unloaded, u, v, f;
};

/// Owned nodes of the face on which the box slides.
std::vector<unsigned> sliding_nodes(const Body& body) {
  std::vector<unsigned> nodes;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    if (node_value(body.vertex_positions(), node)[1] < 1e-9)
      nodes.push_back(node);
  return nodes;
}

TEST(Supports, ProjectionLeavesNodesOnTheirLevelSetsWithTangentialMotion) {
  SupportedBox box;
  box.shake();
  for (unsigned i = 0; i < 3; ++i) { // planes instead of spheres: the rest is of second order
    box.supports.contacts().linearize(box.unloaded, box.u);
    box.supports.contacts().constrain(box.u, box.v, box.f);
  }
  EXPECT_LT(box.supports.contacts().largest_gap(box.unloaded, box.u), 1e-6);
  const Spheres spheres(Point<3>(10., -60., 10.));
  double moved = 0.;
  for (const unsigned node : sliding_nodes(box.body)) {
    const Tensor<1, 3> X = node_value(box.unloaded, node), u = node_value(box.u, node);
    Tensor<1, 3> n;
    const double level = spheres.distance(X, n);
    EXPECT_NEAR(spheres.distance(X + u, n), level, 1e-6);
    EXPECT_NEAR(n * node_value(box.v, node), 0., 1e-4);
    EXPECT_NEAR(n * node_value(box.f, node), 0., 1e-4);
    moved = std::max(moved, u.norm());
  }
  EXPECT_GT(Utilities::MPI::max(moved, MPI_COMM_WORLD), 0.1);
}

TEST(Supports, OneSidedContactHoldsWhatSinksInAndLetsGoWhatLiftsOff) {
  SupportedBox box(ContactLaw::one_sided);
  for (const double direction : {1., -1.}) {
    box.u = 0.;
    box.v = 0.;
    box.f = 0.;
    for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node) {
      box.u.local_element(3 * node + 1) = 0.1 * direction;
      box.v.local_element(3 * node + 1) = direction;
      box.f.local_element(3 * node + 1) = direction;
    }
    box.u.update_ghost_values();
    box.supports.contacts().linearize(box.unloaded, box.u);
    box.supports.contacts().constrain(box.u, box.v, box.f);
    Tensor<1, 3> n;
    const Spheres spheres(Point<3>(10., -60., 10.));
    for (const unsigned node : sliding_nodes(box.body)) {
      const Tensor<1, 3> X = node_value(box.unloaded, node);
      const double gap = spheres.distance(X + node_value(box.u, node), n) - spheres.distance(X, n);
      EXPECT_NEAR(gap, direction > 0. ? 0.1 : 0., 0.005);
      EXPECT_NEAR(n * node_value(box.v, node), direction > 0. ? 1. : 0., 0.05);
      EXPECT_NEAR(n * node_value(box.f, node), direction > 0. ? 1. : 0., 0.05);
    }
  }
}

// An edge between a curved surface and an oblique plane, which is neither along
// nor across it.
TEST(Supports, NodesOnTwoSurfacesStayOnBoth) {
  SupportedBox box;
  const Tensor<1, 3> normal({0.8, 0.6, 0.});
  box.supports.slide_on(std::make_shared<ParallelPlanes>(normal), {2}, ContactLaw::tied);
  box.shake();
  for (unsigned i = 0; i < 4; ++i) {
    box.supports.contacts().linearize(box.unloaded, box.u);
    box.supports.contacts().constrain(box.u, box.v, box.f);
  }
  EXPECT_LT(box.supports.contacts().largest_gap(box.unloaded, box.u), 1e-6);
  for (const unsigned node : sliding_nodes(box.body))
    EXPECT_NEAR(normal * node_value(box.v, node), 0., 1e-9);
}

TEST(Supports, FixedNodesNeitherSlideNorFeelSprings) {
  SupportedBox box;
  box.supports.fix({2});
  box.supports.set_reference(box.unloaded);
  box.shake();
  const NodeVector before = box.f;
  box.supports.add_spring_forces(box.u, box.f);
  box.supports.contacts().set_method(ContactMethod::gradual, {});
  box.supports.contacts().add_correction_forces(
      box.u, box.v, std::vector<double>(box.body.n_local_nodes(), 1.), 1., box.f);
  box.supports.contacts().set_method(ContactMethod::projection, {});
  box.supports.contacts().linearize(box.unloaded, box.u);
  box.supports.contacts().constrain(box.u, box.v, box.f);
  for (unsigned i = 0; i < 3 * box.body.n_owned_nodes(); ++i)
    EXPECT_EQ(box.f.local_element(i), before.local_element(i));
}

// 8 Pa/mm on 400 mm^2, all nodes moved by 1 mm.
TEST(Supports, SpringsPullBackInProportionToTheirArea) {
  SupportedBox box;
  for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node)
    box.u.local_element(3 * node) = 1.;
  box.supports.add_spring_forces(box.u, box.f);
  double sum = 0.;
  for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node)
    sum += box.f.local_element(3 * node);
  EXPECT_NEAR(Utilities::MPI::sum(sum, MPI_COMM_WORLD), -8. * 400., 1e-6);
}

TEST(Supports, SpringsActOnFacesThatPassTheFilter) {
  const auto mesh = make_box(MPI_COMM_WORLD, {4, 2, 2}, size);
  const Body body(*mesh);
  Supports supports(body);
  supports.add_springs(
      {2}, 8., [](const Tensor<1, 3>& centre, const Tensor<1, 3>&) { return centre[0] < 5.; });
  supports.set_reference(body.vertex_positions());
  double sum = 0.;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    sum += supports.spring_stiffness()[node];
    if (node_value(body.vertex_positions(), node)[0] > 5.01) {
      EXPECT_EQ(supports.spring_stiffness()[node], 0.);
    }
  }
  EXPECT_NEAR(Utilities::MPI::sum(sum, MPI_COMM_WORLD), 8. * 100., 1e-6);
}

// 8 Pa/mm on one half of 400 mm^2, and 8 * 3 * 3 Pa/mm on the other.
TEST(Supports, SpringsAreGradedByTheirFaces) {
  const auto mesh = make_box(MPI_COMM_WORLD, {4, 2, 2}, size);
  const Body body(*mesh);
  Supports supports(body);
  supports.add_springs({2}, 5.);
  supports.grade_springs_on(
      2, [](const Tensor<1, 3>& centre, const Tensor<1, 3>&) { return centre[0] < 10. ? 0. : 2.; });
  supports.set_springs_on(2, 8., 3.);
  supports.set_reference(body.vertex_positions());
  double near = 0., far = 0.;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    const double x = node_value(body.vertex_positions(), node)[0];
    (x < 10.1 ? near : far) += supports.spring_stiffness()[node];
  }
  const double middle = 100. * 0.5 * (8. + 72.); // nodes at x = 10 share faces of both sides
  EXPECT_NEAR(Utilities::MPI::sum(near, MPI_COMM_WORLD), 8. * 150. + middle, 1e-6);
  EXPECT_NEAR(Utilities::MPI::sum(far, MPI_COMM_WORLD), 72. * 150., 1e-6);
  double largest = 0.;
  for (const Supports::SpringFace& spring : supports.spring_faces())
    largest = std::max(largest, spring.stiffness);
  EXPECT_NEAR(Utilities::MPI::max(largest, MPI_COMM_WORLD), 72., 1e-9);
}

TEST(SupportForce, TangentsAreItsDerivatives) {
  const SupportedBox box;
  const auto nodal_force = support_force(box.supports, 1000.);
  const auto nodes = sliding_nodes(box.body);
  if (nodes.empty())
    return;
  const Tensor<1, 3> X({8., 0.5, 7.}), x({9., 1.5, 6.5});
  const auto force = [&](const Tensor<1, 3>& X_, const Tensor<1, 3>& x_, Tensor<2, 3>& by_x,
                         Tensor<2, 3>& by_X) {
    Tensor<1, 3> f;
    EXPECT_TRUE(nodal_force->evaluate(nodes.front(), X_, x_, f, by_x, by_X));
    return f;
  };
  Tensor<2, 3> by_x, by_X, unused;
  force(X, x, by_x, by_X);
  const double h = 1e-5;
  for (unsigned d = 0; d < 3; ++d) {
    Tensor<1, 3> step;
    step[d] = h;
    const Tensor<1, 3> column_x =
        (force(X, x + step, unused, unused) - force(X, x - step, unused, unused)) / (2. * h);
    const Tensor<1, 3> column_X =
        (force(X + step, x, unused, unused) - force(X - step, x, unused, unused)) / (2. * h);
    for (unsigned c = 0; c < 3; ++c) {
      EXPECT_NEAR(by_x[c][d], column_x[c], 0.02);
      EXPECT_NEAR(by_X[c][d], column_X[c], 0.02);
    }
  }
}

} // namespace
} // namespace prosup::tests
