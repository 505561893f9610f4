#include "prosup/mechanics/body/contact_surfaces.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace prosup::mechanics {

using namespace dealii;

namespace {

void add_to_node(NodeVector& vector, unsigned node, const Tensor<1, 3>& value) {
  for (unsigned c = 0; c < 3; ++c)
    vector.local_element(3 * node + c) += value[c];
}

} // namespace

void ContactSurfaces::add(std::shared_ptr<const Surface> surface, const BoundaryIds& ids,
                          ContactLaw law, double least_alignment) {
  const auto counts = [&](const Tensor<1, 3>& centre, const Tensor<1, 3>& face_normal) {
    Tensor<1, 3> normal;
    surface->distance(centre, normal);
    return std::abs(face_normal * normal) >= least_alignment;
  };
  const std::vector<bool> slides = nodes_on_boundary(body_, ids, counts);
  const unsigned contact = contacts_.size();
  for (unsigned node = 0; node < slides.size(); ++node)
    if (slides[node]) {
      Node& added = nodes_.emplace_back();
      added.node = node;
      added.contact = contact;
      added.level = surface->distance(node_value(body_.vertex_positions(), node), added.normal);
    }
  contacts_.push_back({std::move(surface), law, ids});
  link_nodes();
}

void ContactSurfaces::remove(const std::vector<bool>& nodes) {
  nodes_.erase(
      std::remove_if(nodes_.begin(), nodes_.end(), [&](const Node& c) { return nodes[c.node]; }),
      nodes_.end());
  link_nodes();
}

void ContactSurfaces::link_nodes() {
  std::vector<int> last(body_.n_local_nodes(), -1);
  for (unsigned i = 0; i < nodes_.size(); ++i)
    nodes_[i].before = std::exchange(last[nodes_[i].node], static_cast<int>(i));
}

/// The unit direction in which a node can move to the surface with this normal
/// and stay on those that come before it.
Tensor<1, 3> ContactSurfaces::across_earlier(const Node& contact,
                                             const Tensor<1, 3>& normal) const {
  Tensor<1, 3> across = normal;
  for (int i = contact.before; i >= 0; i = nodes_[i].before)
    across -= (across * nodes_[i].way_back) * nodes_[i].way_back;
  const double length = across.norm();
  return length > 0.1 ? across / length : Tensor<1, 3>(); // the same plane twice
}

void ContactSurfaces::set_method(ContactMethod method, const GradualCorrection& correction) {
  method_ = method;
  correction_ = correction;
}

bool ContactSurfaces::ties_exactly() const {
  return contacts_.empty() ||
         (method_ == ContactMethod::projection &&
          std::all_of(contacts_.begin(), contacts_.end(),
                      [](const Contact& contact) { return contact.law == ContactLaw::tied; }));
}

void ContactSurfaces::put_on_surfaces(NodeVector& positions) {
  if (method_ == ContactMethod::gradual)
    return;
  for (Node& c : nodes_) {
    const Contact& contact = contacts_[c.contact];
    if (contact.law == ContactLaw::one_sided)
      continue;
    const double gap = contact.surface->distance(node_value(positions, c.node), c.normal) - c.level;
    c.way_back = across_earlier(c, c.normal);
    if (const double slope = c.normal * c.way_back; slope > 0.)
      add_to_node(positions, c.node, -gap / slope * c.way_back);
  }
}

void ContactSurfaces::project(NodeVector& field) const {
  for (const Node& c : nodes_)
    if (c.node < body_.n_owned_nodes())
      add_to_node(field, c.node, -(c.way_back * node_value(field, c.node)) * c.way_back);
}

void ContactSurfaces::linearize(const NodeVector& unloaded, const NodeVector& displacement) {
  for (Node& c : nodes_) {
    const Surface& surface = *contacts_[c.contact].surface;
    const Tensor<1, 3> X = node_value(unloaded, c.node), u = node_value(displacement, c.node);
    // Gradual corrections need a gap for their force, which X has to share.
    const double level =
        method_ == ContactMethod::gradual ? surface.distance(X, c.normal) : c.level;
    c.offset = surface.distance(X + u, c.normal) - level - c.normal * u;
    c.way_back = across_earlier(c, c.normal);
  }
}

void ContactSurfaces::add_correction_forces(const NodeVector& displacement,
                                            const NodeVector& velocity,
                                            const std::vector<double>& mass, double time_step,
                                            NodeVector& force) const {
  if (method_ != ContactMethod::gradual)
    return;
  const double steepness = 10. * std::log(9.) / correction_.speed_limit;
  for (const Node& c : nodes_) {
    if (c.node >= body_.n_owned_nodes())
      continue;
    const double gap = c.offset + c.normal * node_value(displacement, c.node);
    if (contacts_[c.contact].law == ContactLaw::one_sided && gap > 0.)
      continue;
    const double speed = -std::copysign(1., gap) * (c.normal * node_value(velocity, c.node));
    const double part =
        correction_.part / (1. + std::exp(steepness * (speed - correction_.speed_limit)));
    add_to_node(force, c.node, -mass[c.node] * part * gap / (time_step * time_step) * c.normal);
  }
}

void ContactSurfaces::constrain(NodeVector& displacement, NodeVector& velocity,
                                NodeVector& force) const {
  if (method_ == ContactMethod::gradual)
    return;
  for (const Node& c : nodes_) {
    const double slope = c.normal * c.way_back;
    if (c.node >= body_.n_owned_nodes() || !(slope > 0.))
      continue;
    const double gap = c.offset + c.normal * node_value(displacement, c.node);
    double v = c.way_back * node_value(velocity, c.node),
           f = c.way_back * node_value(force, c.node);
    if (contacts_[c.contact].law == ContactLaw::one_sided) {
      if (gap > 0.)
        continue;
      v = std::min(v, 0.);
      f = std::min(f, 0.);
    }
    add_to_node(displacement, c.node, -gap / slope * c.way_back);
    add_to_node(velocity, c.node, -v * c.way_back);
    add_to_node(force, c.node, -f * c.way_back);
  }
}

double ContactSurfaces::largest_gap(const NodeVector& unloaded,
                                    const NodeVector& displacement) const {
  double largest = 0.;
  for (const Node& c : nodes_) {
    if (c.node >= body_.n_owned_nodes())
      continue;
    const Contact& contact = contacts_[c.contact];
    const Tensor<1, 3> X = node_value(unloaded, c.node), u = node_value(displacement, c.node);
    Tensor<1, 3> normal;
    for (const Tensor<1, 3>& position : {X, X + u}) {
      const double gap = contact.surface->distance(position, normal) - c.level;
      largest = std::max(largest, contact.law == ContactLaw::tied ? std::abs(gap) : -gap);
    }
  }
  return Utilities::MPI::max(largest, body_.communicator());
}

} // namespace prosup::mechanics
