#ifndef PROSUP_SRC_PIPELINE_STATE_HDF5_H
#define PROSUP_SRC_PIPELINE_STATE_HDF5_H

#include <mpi.h>

#include <string>

#include "prosup/output/hdf5_file.h"
#include "prosup/registration/registration_state.h"

namespace prosup::pipeline {

/// Writes a breast, of which each rank has its rows or nothing, to a group. Collective on `world`,
/// the communicator of the file.
void write_state(output::Hdf5Writer& file, const std::string& group,
                 const registration::BreastState& breast, MPI_Comm world);
/// Reads it, with all rows on every rank.
registration::BreastState read_breast_state(const output::Hdf5Reader& file,
                                            const std::string& group);

/// The same for a registration.
void write_state(output::Hdf5Writer& file, const registration::RegistrationState& state,
                 MPI_Comm world);
registration::RegistrationState read_registration_state(const output::Hdf5Reader& file);

} // namespace prosup::pipeline

#endif
