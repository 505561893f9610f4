#include "prosup/mechanics/body/supports.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace prosup::mechanics {

using namespace dealii;

Supports::Supports(const Body& body, const BoundaryIds& fixed)
    : body_(body), fixed_(nodes_on_boundary(body, fixed)), contacts_(body) {}

void Supports::fix(const BoundaryIds& ids, const FaceFilter& counts) {
  hold(nodes_on_boundary(body_, ids, counts));
}

void Supports::hold(const std::vector<bool>& nodes) {
  for (unsigned node = 0; node < fixed_.size(); ++node)
    fixed_[node] = fixed_[node] || nodes[node];
  contacts_.remove(fixed_);
}

void Supports::slide_on(std::shared_ptr<const Surface> surface, const BoundaryIds& ids,
                        ContactLaw law, double least_alignment) {
  contacts_.add(std::move(surface), ids, law, least_alignment);
  contacts_.remove(fixed_);
}

void Supports::add_springs(const BoundaryIds& ids, double stiffness, const FaceFilter& counts) {
  springs_.push_back({ids, faces_on_boundary(body_, ids, counts), stiffness, 1., {}});
}

void Supports::grade_springs_on(types::boundary_id id, const FaceValue& exponent) {
  for (Springs& springs : springs_)
    if (springs.ids.count(id) > 0)
      springs.exponents = values_at_faces(body_, springs.faces, exponent);
}

void Supports::set_springs_on(types::boundary_id id, double stiffness, double ratio) {
  for (Springs& springs : springs_)
    if (springs.ids.count(id) > 0) {
      springs.stiffness = stiffness;
      springs.ratio = ratio;
    }
}

std::vector<double> Supports::Springs::weights() const {
  std::vector<double> result;
  if (ratio != 1.)
    for (const double exponent : exponents)
      result.push_back(std::pow(ratio, exponent));
  return result;
}

bool Supports::hold_anything() const {
  const auto any = [](const std::vector<bool>& nodes) {
    return std::find(nodes.begin(), nodes.end(), true) != nodes.end();
  };
  bool here = !contacts_.nodes().empty() || any(fixed_);
  for (const Springs& springs : springs_)
    here = !springs.faces.empty() || here;
  return Utilities::MPI::max(static_cast<int>(here), body_.communicator()) > 0;
}

void Supports::set_reference(const NodeVector& unloaded) {
  if (springs_.empty())
    return;
  spring_stiffness_.assign(body_.n_local_nodes(), 0.);
  for (const Springs& springs : springs_) {
    const std::vector<double> area = lumped_area(body_, springs.faces, unloaded, springs.weights());
    for (unsigned node = 0; node < area.size(); ++node)
      if (!fixed_[node])
        spring_stiffness_[node] += springs.stiffness * area[node];
  }
}

std::vector<Supports::SpringFace> Supports::spring_faces() const {
  std::vector<SpringFace> result;
  for (const Springs& springs : springs_) {
    const std::vector<double> weights = springs.weights();
    for (std::size_t i = 0; i < springs.faces.size(); ++i)
      result.push_back({springs.faces[i], springs.stiffness * (weights.empty() ? 1. : weights[i])});
  }
  return result;
}

void Supports::add_spring_forces(const NodeVector& displacement, NodeVector& force) const {
  if (!spring_stiffness_.empty())
    for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
      if (spring_stiffness_[node] > 0.)
        for (unsigned c = 0; c < 3; ++c)
          force.local_element(3 * node + c) -=
              spring_stiffness_[node] * displacement.local_element(3 * node + c);
}

void Supports::project(NodeVector& field) const {
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    if (fixed_[node])
      std::fill_n(field.begin() + 3 * node, 3, 0.);
  contacts_.project(field);
}

} // namespace prosup::mechanics
