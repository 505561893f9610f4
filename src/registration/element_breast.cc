#include "prosup/registration/element_breast.h"

#include <utility>

#include "prosup/core/collective.h"
#include "prosup/mesh/deformation.h"
#include "prosup/mesh/distributed.h"
#include "prosup/mesh/refine.h"
#include "steps_within.h"

namespace prosup::registration {

using namespace dealii;
using mechanics::node_value;
using mechanics::NodeVector;
using settling::SettlingResult;

namespace {

constexpr auto chest_wall = static_cast<types::boundary_id>(mesh::BoundaryPart::chest_wall);
constexpr auto cut_plane = static_cast<types::boundary_id>(mesh::BoundaryPart::cut_plane);

} // namespace

ElementBreast::ElementBreast(Position position, Parts parts,
                             const mechanics::TissueMaterial& material)
    : position_(position), parts_(std::move(parts)), material_(material) {}

bool ElementBreast::has_gland() const {
  const bool here = material_.has_gland(body().material_ids());
  return Utilities::MPI::max(static_cast<int>(here), body().communicator()) > 0;
}

void ElementBreast::set_properties(const MechanicalProperties& properties) {
  supports().set_springs_on(chest_wall, properties.chest_stiffness);
  supports().set_springs_on(cut_plane, properties.cut_plane_stiffness);
  if (knows_gravity() && position_ == Position::supine)
    unloading().set_gravity_direction(tilted(parts_.gravity, properties.tilt));
  material_of_elements_ = material_.material_of(body().material_ids(), properties.tissue);
  unloading().set_material(material_of_elements_);
}

SettlingResult ElementBreast::unload(unsigned max_steps) {
  return unloading().run(max_steps);
}

SettlingResult ElementBreast::load() {
  is_loaded_ = true;
  unloading().hold_reference();
  return unloading().run();
}

SettlingResult ElementBreast::advance(double duration) {
  return unloading().advance(steps_within(duration, unloading()));
}

void ElementBreast::save() {
  saved_ = unloading().save();
}

void ElementBreast::restore() {
  unloading().restore(*saved_);
}

similarity::Box ElementBreast::unloaded_box() const {
  similarity::Box box;
  for (unsigned node = 0; node < body().n_owned_nodes(); ++node)
    box.include(Point<3>(node_value(unloading().unloaded(), node)));
  return box;
}

const similarity::Samples& ElementBreast::sample(const similarity::SimilarityDomain& domain,
                                                 const image::ScalarImage& image) {
  samples_.emplace(domain, similarity::ImagedBody{&body(), &unloading().unloaded(), &image},
                   domain.excluded == nullptr ? nullptr : &(*domain.excluded)[position_]);
  return samples_->samples();
}

void ElementBreast::set_image_forces(const std::vector<float>& slope,
                                     similarity::Variable variable) {
  samples_->derive_by(variable);
  image_forces_ = samples_->forces(slope);
  samples_.reset();
}

void ElementBreast::add_image_forces(double weight, double momentum, double ramp) {
  if (increment_.size() == 0)
    body().initialize(increment_);
  increment_.sadd(momentum, weight, image_forces_);
  unloading().add_force(increment_, ramp / unloading().damping_rate());
}

mesh::UnloadedMesh ElementBreast::mesh() const {
  const auto at_nodes = [&](const NodeVector& positions) {
    const auto at_cells = body().gather_at_cells(positions);
    return parts_.mesh.cells.empty() ? std::vector<Point<3>>()
                                     : mesh::at_nodes(parts_.mesh, at_cells);
  };
  mesh::UnloadedMesh result{parts_.mesh, at_nodes(unloading().unloaded())};
  if (is_loaded_) {
    NodeVector loaded = unloading().unloaded();
    loaded += unloading().displacement();
    loaded.update_ghost_values();
    result.mesh.points = at_nodes(loaded);
  }
  return result;
}

std::unique_ptr<ElementBreast>
make_element_breast(const BreastModel& model, const BreastInput& input, MPI_Comm communicator) {
  const image::LabelImage& labels = input.scene.labels[input.position];
  const mesh::MeshSource& mesher = input.mesher == nullptr ? model.mesher : *input.mesher;
  const mechanics::Element element = model.elements.element();
  ElementBreast::Parts parts;
  on_root(communicator, [&] { parts.mesh = mesher.mesh(labels); });
  parts.body =
      std::make_unique<mechanics::Body>(*mesh::make_distributed(parts.mesh, communicator), element);
  if (element.degree() == 2)
    on_root(communicator, [&] {
      parts.coarse = std::move(parts.mesh);
      parts.mesh = mesh::refined(parts.coarse);
    });
  input.log.line(format("  %s: %zu cells, %zu nodes", name_of(input.position),
                        parts.mesh.cells.size(), parts.mesh.points.size()));
  parts.supports =
      model.supports.make(input.chest, *parts.body, labels,
                          input.scene.labels[other(input.position)], input.scene.chest_label);
  parts.unloading = std::make_unique<unloading::Unloading>(
      model.unloading, *parts.supports, input.gravity, name_of(input.position), input.log);
  parts.gravity = input.gravity;
  auto breast = std::make_unique<ElementBreast>(input.position, std::move(parts), model.material);
  breast->set_properties(initial_properties(model, input.chest));
  return breast;
}

} // namespace prosup::registration
