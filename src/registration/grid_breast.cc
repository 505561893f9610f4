#include "grid_breast.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "prosup/fdm/breast_mesh.h"
#include "steps_within.h"

namespace prosup::registration {

using namespace dealii;
using fdm::VectorField;
using settling::SettlingResult;

namespace {

/// The labels besides air, chest and what is unknown that a label image has.
std::vector<unsigned> tissues_of(const image::LabelImage& labels, const similarity::Scene& scene) {
  std::set<unsigned> found(labels.values.begin(), labels.values.end());
  found.erase(0);
  found.erase(scene.chest_label);
  found.erase(scene.unknown_label);
  return {found.begin(), found.end()};
}

fdm::ChestContact contact_of(unloading::ChestCondition chest) {
  switch (chest) {
  case unloading::ChestCondition::fixed:
    return fdm::ChestContact::fixed;
  case unloading::ChestCondition::sliding:
    return fdm::ChestContact::sliding;
  default:
    return fdm::ChestContact::one_sided;
  }
}

/// Calls `work` with the position X and displacement of each grid point.
template <typename Work>
void for_each_point(const VectorField& u, Work&& work) {
  std::size_t node = 0;
  for (std::size_t k = 0; k < u.grid.size[2]; ++k)
    for (std::size_t j = 0; j < u.grid.size[1]; ++j)
      for (std::size_t i = 0; i < u.grid.size[0]; ++i, ++node)
        work(
            u.grid.physical(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)),
            u.values[node]);
}

} // namespace

GridBreast::GridBreast(const BreastModel& model, const BreastInput& input, MPI_Comm communicator)
    : position_(input.position), scene_(input.scene), model_(model), communicator_(communicator) {
  const double chest_stiffness = model.supports.chest_stiffness(input.chest);
  const Tensor<1, 3> gravity = model.unloading.gravity / input.gravity.norm() * input.gravity;
  unloading_ =
      std::make_unique<fdm::FdmUnloading>(model.fdm,
                                          fdm::FdmBody{labels(),
                                                       scene_.chest_label,
                                                       material(model.material.initial()),
                                                       gravity,
                                                       {contact_of(input.chest), chest_stiffness},
                                                       model.unloading.density},
                                          communicator, name_of(position_), input.log);
}

fdm::Material GridBreast::material(const mechanics::TissueStiffness& stiffness) const {
  const std::vector<unsigned> tissues = tissues_of(labels(), scene_);
  model_.material.require_model("neo-hookean", "the finite-difference method");
  if (stiffness.skin_stiffness > 0.)
    throw Error("'Material/Skin stiffness' is larger than 0, but finite differences know no skin; "
                "set it to 0 or choose 'Simulation/Method' = fe.");
  const mechanics::Material material = model_.material.material_of(tissues, stiffness);
  fdm::Material result;
  for (std::size_t i = 0; i < tissues.size(); ++i) {
    const mechanics::LameParameters& lame = material[i];
    result.tissues[tissues[i]] = {lame.mu, lame.lambda};
  }
  return result;
}

bool GridBreast::has_gland() const {
  return model_.material.has_gland(tissues_of(labels(), scene_));
}

void GridBreast::set_properties(const MechanicalProperties& properties) {
  unloading_->set_material(material(properties.tissue));
  if (properties.lateral_chest_ratio != 1.)
    throw Error(
        "'Supports/Lateral chest ratio' is not 1, but finite differences know one stiffness "
        "of the chest only; set it to 1 or choose 'Simulation/Method' = fe.");
  unloading_->set_spring_stiffness(properties.chest_stiffness);
}

SettlingResult GridBreast::of_tissue(SettlingResult result) const {
  const VectorField u = unloading_->displacement();
  result.min_jacobian = std::numeric_limits<double>::max();
  for_each_point(u, [&](const Point<3>& X, const Tensor<1, 3>& displacement) {
    if (cover_at(scene_, position_, X + displacement) == similarity::cover::tissue)
      result.min_jacobian = std::min(result.min_jacobian, determinant(deformation_gradient(u, X)));
  });
  return result;
}

SettlingResult GridBreast::unload(const settling::Effort& effort) {
  return of_tissue(unloading_->run(effort));
}

SettlingResult GridBreast::load() {
  unloading_->hold_reference();
  return unloading_->run();
}

SettlingResult GridBreast::advance(double duration) {
  return of_tissue(unloading_->advance(steps_within(duration, *unloading_)));
}

void GridBreast::save() {
  saved_ = unloading_->save();
}

void GridBreast::restore() {
  unloading_->restore(saved_);
}

similarity::Box GridBreast::unloaded_box() const {
  const VectorField u = unloading_->displacement();
  similarity::Box box;
  for_each_point(u, [&](const Point<3>& X, const Tensor<1, 3>& displacement) {
    if (cover_at(scene_, position_, X + displacement) == similarity::cover::tissue)
      box.include(X);
  });
  box.grow(u.grid.spacing[0]); // tissue goes on beyond the last point
  return box;
}

const similarity::Samples& GridBreast::sample(const similarity::SimilarityDomain& domain,
                                              const image::ScalarImage& image) {
  samples_.emplace(domain, scene_, position_, unloading_->displacement(), image, communicator_);
  return samples_->samples();
}

void GridBreast::set_image_forces(const std::vector<float>& slope, similarity::Variable variable) {
  image_forces_ = samples_->forces(slope, variable);
}

void GridBreast::add_image_forces(double weight, double momentum, double ramp) {
  increment_.resize(image_forces_.values.size());
  for (std::size_t i = 0; i < increment_.size(); ++i)
    increment_[i] = momentum * increment_[i] + weight * image_forces_.values[i];
  unloading_->add_force({image_forces_.grid, increment_}, ramp / unloading_->damping_rate());
}

mesh::UnloadedMesh GridBreast::mesh() const {
  const VectorField displacement = unloading_->displacement();
  if (Utilities::MPI::this_mpi_process(communicator_) != 0)
    return {};
  fdm::BreastMesh breast = fdm::breast_mesh(displacement, labels(), tissues_of(labels(), scene_));
  mesh::UnloadedMesh result;
  result.mesh.points = std::move(breast.loaded);
  result.mesh.cells = std::move(breast.cells);
  result.mesh.tissue = std::move(breast.tissue);
  result.unloaded = std::move(breast.unloaded);
  return result;
}

} // namespace prosup::registration
