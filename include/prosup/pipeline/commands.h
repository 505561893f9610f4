#ifndef PROSUP_PIPELINE_COMMANDS_H
#define PROSUP_PIPELINE_COMMANDS_H

#include <deal.II/base/parameter_handler.h>
#include <mpi.h>

#include <filesystem>
#include <string>

#include "prosup/pipeline/stages.h"

namespace prosup::pipeline {

/// `prosup mesh`: the mask of one state to a mesh with a quality report.
void run_mesh(const Stages& stages, const dealii::ParameterHandler& parameters,
              const std::filesystem::path& output, MPI_Comm world);

/// `prosup unload`: one state to its unloaded configuration. Returns whether
/// it settled.
bool run_unload(const Stages& stages, const dealii::ParameterHandler& parameters,
                const std::filesystem::path& output, MPI_Comm world);

/// `prosup load`: one unloaded state to its loaded configuration. Returns
/// whether it settled.
bool run_load(const Stages& stages, const dealii::ParameterHandler& parameters,
              const std::filesystem::path& output, MPI_Comm world);

/// `prosup phantom`: images of a numerical phantom, with their truth.
void run_phantom(const Stages& stages, const dealii::ParameterHandler& parameters,
                 const std::filesystem::path& output, MPI_Comm world);

/// What `prosup map` is asked for.
struct MapRequest {
  std::filesystem::path result; ///< folder of a finished registration
  std::string from, to;         ///< prone, supine or unloaded
  std::filesystem::path points, output;
};

/// `prosup map`: points from one state to another with a finished registration.
/// For one rank.
void run_map(const MapRequest& request);

} // namespace prosup::pipeline

#endif
