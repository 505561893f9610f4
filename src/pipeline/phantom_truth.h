#ifndef PROSUP_SRC_PIPELINE_PHANTOM_TRUTH_H
#define PROSUP_SRC_PIPELINE_PHANTOM_TRUTH_H

#include <filesystem>

#include "prosup/core/position.h"
#include "prosup/evaluation/target_registration_error.h"
#include "prosup/mechanics/static/quasi_static.h"
#include "prosup/phantom/phantom_parameters.h"
#include "prosup/unloading/unloading_parameters.h"

namespace prosup::pipeline {

/// How a phantom was made, and what was found on the way.
struct PhantomTruth {
  const phantom::PhantomParameters& phantom;
  const unloading::UnloadingParameters& load;          ///< density and gravity
  PerPosition<dealii::Tensor<1, 3>> gravity_direction; ///< LPS
  PerPosition<mechanics::QuasiStaticResult> results;
  evaluation::ErrorStatistics initial_error; ///< distances of the landmarks, mm
};

/// Writes `truth.json`: how a phantom was made, and what a registration of it should find.
/// @throws Error if the file cannot be written.
void write_phantom_truth(const PhantomTruth& truth, const std::filesystem::path& file);

} // namespace prosup::pipeline

#endif
