#include "finite_elements.h"

#include "prosup/registration/simulated_bodies.h"

namespace prosup::pipeline {

void FiniteElements::build(Inputs& inputs) {
  scene_ = &inputs.scene;
  meshes_ = build_bodies(stages_, inputs, pair_, log_);
}

std::array<settling::SettlingResult, 2> FiniteElements::unload() {
  pair_.set_properties(stages_.material, {stages_.material.initial(),
                                          stages_.supports.chest_stiffness(stages_.scene.chest())});
  return pair_.unload();
}

registration::MaterialUpdateResult
FiniteElements::update_material(const registration::Observer& observer) {
  registration::SimulatedBodies bodies(pair_, similarity_, *scene_, stages_.material);
  return stages_.material_update.run(bodies, similarity_.metric(), log_, observer);
}

registration::ImageForceResult
FiniteElements::push_with_image_forces(const registration::Observer& observer) {
  return stages_.image_forces.run(pair_, similarity_, *scene_, stages_.material, log_, observer);
}

} // namespace prosup::pipeline
