#include "prosup/mechanics/body/supports.h"

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

Supports::Supports(const Body& body, const BoundaryIds& fixed)
    : body_(body), fixed_(body.nodes_on_boundary(fixed)) {}

void Supports::fix(const BoundaryIds& ids, const Body::FaceFilter& counts) {
  const std::vector<bool> held = body_.nodes_on_boundary(ids, counts);
  for (unsigned node = 0; node < fixed_.size(); ++node)
    fixed_[node] = fixed_[node] || held[node];
  forget_fixed_nodes();
}

void Supports::slide_on(std::shared_ptr<const Surface> surface, const BoundaryIds& ids,
                        ContactLaw law, double least_alignment) {
  const auto counts = [&](const Tensor<1, 3>& centre, const Tensor<1, 3>& face_normal) {
    Tensor<1, 3> normal;
    surface->distance(centre, normal);
    return std::abs(face_normal * normal) >= least_alignment;
  };
  const std::vector<bool> slides = body_.nodes_on_boundary(ids, counts);
  const unsigned contact = contacts_.size();
  for (unsigned node = 0; node < slides.size(); ++node)
    if (slides[node]) {
      ContactNode& added = contact_nodes_.emplace_back();
      added.node = node;
      added.contact = contact;
      added.level = surface->distance(node_value(body_.vertex_positions(), node), added.normal);
    }
  contacts_.push_back({std::move(surface), law, ids});
  forget_fixed_nodes();
}

void Supports::forget_fixed_nodes() {
  contact_nodes_.erase(std::remove_if(contact_nodes_.begin(), contact_nodes_.end(),
                                      [&](const ContactNode& c) { return fixed_[c.node]; }),
                       contact_nodes_.end());
  link_contacts();
}

void Supports::link_contacts() {
  std::vector<int> last(body_.n_local_nodes(), -1);
  for (unsigned i = 0; i < contact_nodes_.size(); ++i)
    contact_nodes_[i].before = std::exchange(last[contact_nodes_[i].node], static_cast<int>(i));
}

/// The unit direction in which a node can move to the surface with this normal
/// and stay on those that come before it.
Tensor<1, 3> Supports::across_earlier(const ContactNode& contact,
                                      const Tensor<1, 3>& normal) const {
  Tensor<1, 3> across = normal;
  for (int i = contact.before; i >= 0; i = contact_nodes_[i].before)
    across -= (across * contact_nodes_[i].way_back) * contact_nodes_[i].way_back;
  const double length = across.norm();
  return length > 0.1 ? across / length : Tensor<1, 3>(); // the same plane twice
}

void Supports::add_springs(const BoundaryIds& ids, double stiffness) {
  springs_.push_back({ids, stiffness});
}

void Supports::set_springs_on(types::boundary_id id, double stiffness) {
  for (Springs& springs : springs_)
    if (springs.ids.count(id) > 0)
      springs.stiffness = stiffness;
}

void Supports::set_contact_method(ContactMethod method, const GradualCorrection& correction) {
  method_ = method;
  correction_ = correction;
}

bool Supports::hold_anything() const {
  const auto any = [](const std::vector<bool>& nodes) {
    return std::find(nodes.begin(), nodes.end(), true) != nodes.end();
  };
  bool here = !contact_nodes_.empty() || any(fixed_);
  for (const Springs& springs : springs_)
    here = any(body_.nodes_on_boundary(springs.ids)) || here;
  return Utilities::MPI::max(static_cast<int>(here), body_.communicator()) > 0;
}

void Supports::set_reference(const NodeVector& unloaded) {
  if (springs_.empty())
    return;
  spring_stiffness_.assign(body_.n_local_nodes(), 0.);
  for (const Springs& springs : springs_) {
    const std::vector<double> area = body_.lumped_area(springs.ids, unloaded);
    for (unsigned node = 0; node < area.size(); ++node)
      if (!fixed_[node])
        spring_stiffness_[node] += springs.stiffness * area[node];
  }
}

void Supports::put_on_surfaces(NodeVector& positions) {
  if (method_ == ContactMethod::gradual)
    return;
  for (ContactNode& c : contact_nodes_) {
    const Contact& contact = contacts_[c.contact];
    if (contact.law == ContactLaw::one_sided)
      continue;
    const double gap = contact.surface->distance(node_value(positions, c.node), c.normal) - c.level;
    c.way_back = across_earlier(c, c.normal);
    if (const double slope = c.normal * c.way_back; slope > 0.)
      add_to_node(positions, c.node, -gap / slope * c.way_back);
  }
}

void Supports::project(NodeVector& field) const {
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    if (fixed_[node])
      std::fill_n(field.begin() + 3 * node, 3, 0.);
  for (const ContactNode& c : contact_nodes_)
    if (c.node < body_.n_owned_nodes())
      add_to_node(field, c.node, -(c.way_back * node_value(field, c.node)) * c.way_back);
}

void Supports::linearize(const NodeVector& unloaded, const NodeVector& displacement) {
  for (ContactNode& c : contact_nodes_) {
    const Surface& surface = *contacts_[c.contact].surface;
    const Tensor<1, 3> X = node_value(unloaded, c.node), u = node_value(displacement, c.node);
    // Gradual corrections need a gap for their force, which X has to share.
    const double level =
        method_ == ContactMethod::gradual ? surface.distance(X, c.normal) : c.level;
    c.offset = surface.distance(X + u, c.normal) - level - c.normal * u;
    c.way_back = across_earlier(c, c.normal);
  }
}

void Supports::add_spring_forces(const NodeVector& displacement, NodeVector& force) const {
  if (!spring_stiffness_.empty())
    for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
      if (spring_stiffness_[node] > 0.)
        add_to_node(force, node, -spring_stiffness_[node] * node_value(displacement, node));
}

void Supports::add_forces(const NodeVector& displacement, const NodeVector& velocity,
                          const std::vector<double>& mass, double time_step,
                          NodeVector& force) const {
  add_spring_forces(displacement, force);
  if (method_ != ContactMethod::gradual)
    return;
  const double steepness = 10. * std::log(9.) / correction_.speed_limit;
  for (const ContactNode& c : contact_nodes_) {
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

void Supports::constrain(NodeVector& displacement, NodeVector& velocity, NodeVector& force) const {
  if (method_ == ContactMethod::gradual)
    return;
  for (const ContactNode& c : contact_nodes_) {
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

double Supports::largest_gap(const NodeVector& unloaded, const NodeVector& displacement) const {
  double largest = 0.;
  for (const ContactNode& c : contact_nodes_) {
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

/// Penalty and springs, as nodal forces.
class Supports::Force : public NodalForce {
public:
  Force(const Supports& supports, double contact_stiffness)
      : supports_(supports), penalties_(supports.body_.n_local_nodes()) {
    std::vector<std::vector<double>> areas;
    for (const Contact& contact : supports.contacts_)
      areas.push_back(supports.body_.lumped_area(contact.ids, supports.body_.vertex_positions()));
    for (const ContactNode& c : supports.contact_nodes_)
      penalties_[c.node].push_back(
          {&supports.contacts_[c.contact], contact_stiffness * areas[c.contact][c.node]});
  }

  bool evaluate(unsigned node, const Tensor<1, 3>& X, const Tensor<1, 3>& x, Tensor<1, 3>& force,
                Tensor<2, 3>& by_x, Tensor<2, 3>& by_X) const override {
    const auto& springs = supports_.spring_stiffness_;
    const double spring = springs.empty() ? 0. : springs[node];
    if (!(spring > 0.) && penalties_[node].empty())
      return false;
    force = -spring * (x - X);
    by_x = -spring * unit_symmetric_tensor<3>();
    by_X = -by_x;
    for (const Penalty& penalty : penalties_[node])
      penalty.add(X, x, force, by_x, by_X);
    return true;
  }

private:
  struct Penalty {
    const Contact* contact;
    double stiffness; ///< g/s^2

    /// f = -k (d(x) - d(X)) n(x).
    void add(const Tensor<1, 3>& X, const Tensor<1, 3>& x, Tensor<1, 3>& force, Tensor<2, 3>& by_x,
             Tensor<2, 3>& by_X) const {
      Tensor<1, 3> n, n_before;
      const Surface& surface = *contact->surface;
      const double gap = surface.distance(x, n) - surface.distance(X, n_before);
      if (contact->law == ContactLaw::one_sided && gap > 0.)
        return;
      force -= stiffness * gap * n;
      by_x -= stiffness * (outer_product(n, n) + gap * surface.curvature(x));
      by_X += stiffness * outer_product(n, n_before);
    }
  };

  const Supports& supports_;
  std::vector<std::vector<Penalty>> penalties_; // of each local node
};

std::unique_ptr<NodalForce> Supports::nodal_force(double contact_stiffness) const {
  return std::make_unique<Force>(*this, contact_stiffness);
}

} // namespace prosup::mechanics
