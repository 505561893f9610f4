#ifndef PROSUP_PIPELINE_CHEST_ALIGNMENT_H
#define PROSUP_PIPELINE_CHEST_ALIGNMENT_H

#include <mpi.h>

#include <optional>

#include "prosup/core/log.h"
#include "prosup/output/summary.h"
#include "prosup/pipeline/inputs.h"
#include "prosup/registration/pre_alignment.h"

namespace prosup::pipeline {

/// Lays the supine chest of `inputs` on the prone one if that is asked for, and
/// tells how on rank 0. Collective.
/// @throws Error if the chests have nothing in common.
std::optional<output::AlignmentSummary> align_chests(const registration::PreAlignment& method,
                                                     Inputs& inputs, const Log& log,
                                                     MPI_Comm communicator);

} // namespace prosup::pipeline

#endif
