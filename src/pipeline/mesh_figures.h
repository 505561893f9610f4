#ifndef PROSUP_SRC_PIPELINE_MESH_FIGURES_H
#define PROSUP_SRC_PIPELINE_MESH_FIGURES_H

#include "prosup/evaluation/target_registration_error.h"
#include "prosup/registration/quality.h"
#include "prosup/registration/registration.h"

namespace prosup::pipeline {

/// Sets what the meshes of a finished registration tell of its quality, and returns its inverse
/// consistency. `gravity` are the directions in both positions, `alignment` leads from supine
/// coordinates to prone ones. For the rank that has the meshes.
evaluation::ErrorStatistics measure_meshes(const registration::RegistrationResult& found,
                                           const PerPosition<dealii::Tensor<1, 3>>& gravity,
                                           const image::RigidTransform& alignment,
                                           registration::Quality& quality);

} // namespace prosup::pipeline

#endif
