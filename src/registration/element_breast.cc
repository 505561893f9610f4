#include "prosup/registration/element_breast.h"

#include <utility>

#include "prosup/core/collective.h"
#include "prosup/mesh/deformation.h"
#include "prosup/mesh/distributed.h"
#include "prosup/mesh/quality.h"
#include "prosup/mesh/refine.h"
#include "prosup/registration/completed_labels.h"
#include "steps_within.h"

namespace prosup::registration {

using namespace dealii;
using mechanics::node_value;
using mechanics::NodeVector;
using settling::SettlingResult;

namespace {

constexpr double shorter_edge = 0.87;   // of what was asked for
constexpr double worth_a_remark = 0.02; // of the faces of a base

constexpr auto chest_wall = mesh::boundary_id_of(mesh::BoundaryPart::chest_wall);
constexpr auto cut_plane = mesh::boundary_id_of(mesh::BoundaryPart::cut_plane);
constexpr auto skin = mesh::boundary_id_of(mesh::BoundaryPart::skin);

} // namespace

ElementBreast::ElementBreast(Position position, Parts parts,
                             const mechanics::TissueMaterial& material)
    : position_(position), parts_(std::move(parts)), material_(material) {}

bool ElementBreast::has_gland() const {
  const bool here = material_.has_gland(body().material_ids());
  return Utilities::MPI::max(static_cast<int>(here), body().communicator()) > 0;
}

void ElementBreast::set_properties(const MechanicalProperties& properties) {
  supports().set_springs_on(chest_wall, properties.chest_stiffness, properties.lateral_chest_ratio);
  supports().set_springs_on(cut_plane, properties.cut_plane_stiffness[position_]);
  if (knows_gravity() && position_ == Position::supine)
    unloading().set_gravity_direction(tilted(parts_.gravity, properties.tilt));
  material_of_elements_ = material_.material_of(body().material_ids(), properties.tissue);
  material_of_elements_.set_skin({skin, properties.tissue.skin_stiffness});
  unloading().set_material(material_of_elements_);
}

SettlingResult ElementBreast::unload(const settling::Effort& effort) {
  SettlingResult result = unloading().run(effort);
  result.remarks = parts_.remarks;
  const auto& more = unloading().remarks();
  result.remarks.insert(result.remarks.end(), more.begin(), more.end());
  return result;
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

namespace {

/// The mesher takes shorter edges where thin parts of the mask make it fail.
void tell_shorter_edges(const mesh::TetMesh& mesh, double wanted, Position position,
                        std::vector<std::string>& remarks) {
  const mesh::MeshQuality quality = mesh::measure_quality(mesh);
  if (quality.mean_edge < shorter_edge * wanted)
    remarks.push_back(format("Thin parts of the mask made the %s breast need shorter edges, %.2g "
                             "mm instead of 'Meshing/Edge length' = %g, and %zu cells; cut thin "
                             "folds and islands from the mask.",
                             name_of(position), quality.mean_edge, wanted, quality.n_cells));
}

/// Says how much of the base does not slide although it should.
void tell_held(const unloading::BaseFaces& faces, const BreastInput& input,
               std::vector<std::string>& remarks) {
  if (faces.n_held == 0)
    return;
  const std::string text = format("%u of %u faces of the base of the %s breast", faces.n_held,
                                  faces.n_all, name_of(input.position));
  input.log.line("  " + text + " are held: the chest has no clear normal there");
  if (faces.n_held > worth_a_remark * faces.n_all)
    remarks.push_back(text + " do not slide, since the chest label has no clear normal there; "
                             "smooth it, or take 'Case/Chest' = fixed.");
}

} // namespace

std::unique_ptr<ElementBreast>
make_element_breast(const BreastModel& model, const BreastInput& input, MPI_Comm communicator) {
  const image::LabelImage& given = input.scene.labels[input.position];
  std::vector<std::string> remarks;
  const image::LabelImage labels = completed_labels(given, input.position, input.scene.chest_label,
                                                    input.scene.unknown_label, input.log, remarks);
  const mesh::MeshSource& mesher = input.mesher == nullptr ? model.mesher : *input.mesher;
  const mechanics::Element element = model.elements.element();
  ElementBreast::Parts parts;
  on_root(communicator, [&] {
    parts.mesh = mesher.mesh(labels);
    if (input.mesher == nullptr)
      tell_shorter_edges(parts.mesh, model.mesher.edge_length, input.position, remarks);
  });
  parts.body =
      std::make_unique<mechanics::Body>(*mesh::make_distributed(parts.mesh, communicator), element);
  if (element.degree() == 2)
    on_root(communicator, [&] {
      parts.coarse = std::move(parts.mesh);
      parts.mesh = mesh::refined(parts.coarse);
    });
  input.log.line(format("  %s: %zu cells, %zu nodes", name_of(input.position),
                        parts.mesh.cells.size(), parts.mesh.points.size()));
  unloading::BaseFaces faces;
  parts.supports = model.supports.make(input.chest, *parts.body, labels,
                                       input.scene.labels[other(input.position)],
                                       input.scene.chest_label, &faces);
  tell_held(faces, input, remarks);
  parts.remarks = std::move(remarks);
  parts.unloading = std::make_unique<unloading::Unloading>(
      model.unloading, *parts.supports, input.gravity, name_of(input.position), input.log);
  parts.gravity = input.gravity;
  auto breast = std::make_unique<ElementBreast>(input.position, std::move(parts), model.material);
  breast->set_properties(initial_properties(model, input.chest));
  return breast;
}

} // namespace prosup::registration
