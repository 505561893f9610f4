#ifndef PROSUP_REGISTRATION_REGISTRATION_STATE_H
#define PROSUP_REGISTRATION_REGISTRATION_STATE_H

#include "prosup/core/position.h"
#include "prosup/image/rigid_transform.h"
#include "prosup/registration/breast_state.h"
#include "prosup/registration/image_force_registration.h"
#include "prosup/registration/material_update.h"

namespace prosup::registration {

/// What a registration has done.
enum class Stage { nothing, built, unloaded, properties_matched, images_matched };

/// What a registration goes on from: Registration::state() and resume(). Everything is the same on
/// all ranks but for the breasts, which are those that the rank holds.
struct RegistrationState {
  Stage stage = Stage::nothing;
  image::RigidTransform alignment; ///< of the supine inputs
  MechanicalProperties properties;
  bool converged = true;
  PerPosition<settling::SettlingResult> unloaded; ///< of unload()
  MaterialProgress material;                      ///< of match_properties()
  ImageForceProgress image_forces;                ///< of match_images(), but for its fields
  PerPosition<BreastState> breasts;
};

} // namespace prosup::registration

#endif
