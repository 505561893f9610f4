#include "prosup/mechanics/element/internal_force.h"

#include <deal.II/base/aligned_vector.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <variant>

#include "element_batches.h"
#include "element_kernel.h"
#include "element_stiffness.h"
#include "membrane.h"

namespace prosup::mechanics {

using namespace dealii;
using kernel::node_stride;

namespace {

void pack(const NodeVector& vector, unsigned first, unsigned last, double* packed) {
  const double* v = vector.begin() + 3 * std::size_t(first);
  for (double* p = packed + node_stride * std::size_t(first);
       p < packed + node_stride * std::size_t(last); p += node_stride, v += 3)
    for (unsigned c = 0; c < 3; ++c)
      p[c] = v[c];
}

void pack_sum(const NodeVector& a, const double* b, unsigned first, unsigned last, double* packed) {
  const double* v = a.begin() + 3 * std::size_t(first);
  for (std::size_t i = node_stride * std::size_t(first); i < node_stride * std::size_t(last);
       i += node_stride, v += 3)
    for (unsigned c = 0; c < 3; ++c)
      packed[i + c] = v[c] + b[i + c];
}

} // namespace

struct InternalForce::Implementation {
  const Body& body;
  const bool is_averaged;
  const std::unique_ptr<ElementBatches> elements;
  Material material;
  std::unique_ptr<Membrane> skin; // if there is any
  NodeVector reference_positions;
  bool has_reference = false;
  // In the kernels' layout.
  AlignedVector<double> reference, positions, force;
  NodeVector exchanged;
  // Averaged nodal pressure: V_a and V_a lambda_a, and the present volumes.
  std::vector<double> nodal_volume, nodal_lambda, present_volume;

  explicit Implementation(const Body& body)
      : body(body), is_averaged(body.element().type == ElementType::nodal_pressure),
        elements(ElementBatches::create(body)) {
    const std::size_t n = std::size_t(body.n_local_nodes()) + n_padding_nodes;
    for (AlignedVector<double>* field : {&reference, &positions, &force}) {
      field->resize(node_stride * n, 0.);
      if (field != &force)
        place_padding_nodes(field->data() + node_stride * std::size_t(body.n_local_nodes()));
    }
    body.initialize(exchanged);
    body.initialize(reference_positions);
    if (is_averaged)
      present_volume.resize(n);
  }

  std::vector<double> volumes_at(const double* at) {
    std::fill(present_volume.begin(), present_volume.end(), 0.);
    for (const auto part : {ElementBatches::interface, ElementBatches::first_interior,
                            ElementBatches::second_interior})
      elements->add_nodal_volumes(part, at, present_volume.data());
    return sum_over_ranks(body, present_volume);
  }

  /// Writes the nodal pressures dU/dJ(J_a) behind the positions.
  void average_pressure() {
    const std::vector<double> volume = volumes_at(positions.data());
    const auto write = [&](const auto& law) {
      for (unsigned node = 0; node < body.n_local_nodes(); ++node) {
        const double J = std::max(volume[node] / nodal_volume[node], 1e-3);
        positions[node_stride * std::size_t(node) + 3] =
            law.volume_slope(nodal_lambda[node], std::log(J)) / J;
      }
    };
    std::visit(write, material.law());
  }

  void average_material() {
    if (!is_averaged || material.is_empty() || nodal_volume.empty())
      return;
    nodal_lambda.assign(body.n_local_nodes(), 0.);
    const ElementShape& shape = element_shape(body.element().type);
    for (unsigned e = 0; e < body.n_elements(); ++e) {
      const unsigned* nodes = body.element_nodes(e);
      const double quarter = determinant(shape.derivative(0, nodes, reference_positions)) / 24.;
      for (unsigned a = 0; a < 4; ++a)
        nodal_lambda[nodes[a]] += quarter * material[e].lambda;
    }
    nodal_lambda = sum_over_ranks(body, nodal_lambda);
    for (unsigned node = 0; node < body.n_local_nodes(); ++node)
      nodal_lambda[node] /= nodal_volume[node];
  }

  double add_forces(ElementBatches::Part part) {
    return elements->add_forces(part, positions.data(), force.data());
  }

  /// Local, so that a rank without skin need not know of it.
  void make_skin() {
    skin.reset();
    if (material.skin().stiffness > 0.)
      skin = std::make_unique<Membrane>(body, material.skin());
    if (skin && has_reference)
      skin->set_reference(reference_positions);
  }

  /// Forces on ghosts go to their owners, to arrive in `exchanged`.
  void send_ghost_forces() {
    exchanged = 0.;
    for (unsigned node = body.n_owned_nodes(); node < body.n_local_nodes(); ++node)
      for (unsigned c = 0; c < 3; ++c)
        exchanged.local_element(3 * node + c) = force[node_stride * std::size_t(node) + c];
    exchanged.compress_start(0, VectorOperation::add);
  }
};

InternalForce::InternalForce(const Body& body)
    : implementation_(std::make_unique<Implementation>(body)) {}

InternalForce::~InternalForce() = default;

void InternalForce::set_material(const Material& material) {
  implementation_->material = material;
  implementation_->elements->set_material(material);
  implementation_->average_material();
  implementation_->make_skin();
}

double InternalForce::set_reference(const NodeVector& reference) {
  Implementation& self = *implementation_;
  std::copy_n(reference.begin(), 3 * std::size_t(self.body.n_local_nodes()),
              self.reference_positions.begin());
  self.has_reference = true;
  pack(self.reference_positions, 0, self.body.n_local_nodes(), self.reference.data());
  const double smallest = self.elements->set_reference(self.reference.data()) / 6.;
  if (self.is_averaged) {
    self.nodal_volume = self.volumes_at(self.reference.data());
    self.average_material();
  }
  if (self.skin)
    self.skin->set_reference(self.reference_positions);
  return smallest;
}

double InternalForce::subtract(const NodeVector& displacement, NodeVector& force) const {
  Implementation& self = *implementation_;
  const unsigned n_owned = self.body.n_owned_nodes(), n_local = self.body.n_local_nodes();
  displacement.update_ghost_values_start();
  self.force.fill(0.);
  pack_sum(displacement, self.reference.data(), 0, n_owned, self.positions.data());
  double smallest = std::numeric_limits<double>::max();
  const auto add = [&](ElementBatches::Part part) {
    smallest = std::min(smallest, self.add_forces(part));
  };
  if (!self.is_averaged)
    add(ElementBatches::first_interior);
  displacement.update_ghost_values_finish();
  pack_sum(displacement, self.reference.data(), n_owned, n_local, self.positions.data());
  if (self.is_averaged) {
    self.average_pressure();
    add(ElementBatches::first_interior);
  }
  add(ElementBatches::interface);
  if (self.skin)
    self.skin->add_forces(self.positions.data(), self.force.data());
  self.send_ghost_forces();
  add(ElementBatches::second_interior);
  self.exchanged.compress_finish(VectorOperation::add);

  const double* f = self.force.data();
  const double* from_others = self.exchanged.begin();
  double* result = force.begin();
  for (unsigned node = 0; node < n_owned; ++node, f += node_stride)
    for (unsigned c = 0; c < 3; ++c)
      *result++ -= f[c] + *from_others++;
  return smallest;
}

std::vector<double> InternalForce::nodal_volume() const {
  return element_nodal_volume(implementation_->body, implementation_->reference_positions);
}

std::vector<double> InternalForce::lumped_volume() const {
  return element_lumped_volume(implementation_->body, implementation_->reference_positions);
}

std::vector<double> InternalForce::stiffness_bound(const NodeVector& displacement) const {
  displacement.update_ghost_values();
  const Implementation& self = *implementation_;
  std::vector<double> bound =
      element_stiffness_bound(self.body, self.reference_positions, displacement, self.material);
  if (self.material.skin().stiffness > 0.) {
    std::vector<double> of_skin(bound.size(), 0.);
    self.skin->add_stiffness_bound(self.reference_positions, displacement, of_skin);
    of_skin = sum_over_ranks(self.body, of_skin);
    std::transform(bound.begin(), bound.end(), of_skin.begin(), bound.begin(), std::plus<>());
  }
  return bound;
}

InternalForce::WorstCell InternalForce::worst_cell(const NodeVector& positions,
                                                   const NodeVector& displacement) const {
  const Body& body = implementation_->body;
  const ElementShape& shape = element_shape(body.element().type);
  double smallest = std::numeric_limits<double>::max();
  unsigned worst = 0;
  for (unsigned e = 0; e < body.n_elements(); ++e)
    for (unsigned q = 0; q < shape.n_points; ++q) {
      const double J = point_jacobian(shape, q, body.element_nodes(e),
                                      implementation_->reference_positions, displacement);
      if (J < smallest) { // false if not a number
        smallest = J;
        worst = e;
      }
    }
  WorstCell result{smallest, 0, {}};
  if (body.n_elements() == 0)
    return result;
  for (unsigned a = 0; a < 4; ++a)
    result.centre += 0.25 * node_value(positions, body.element_nodes(worst)[a]);
  result.cell = body.cell_ids()[worst * body.element().n_cells()] / body.element().n_cells();
  return result;
}

} // namespace prosup::mechanics
