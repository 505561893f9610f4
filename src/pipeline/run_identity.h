#ifndef PROSUP_SRC_PIPELINE_RUN_IDENTITY_H
#define PROSUP_SRC_PIPELINE_RUN_IDENTITY_H

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace prosup::pipeline {

/// What a run computes from, as lines "Section/Entry = value".
struct RunIdentity {
  std::string parameters; ///< but for those that name files, and those of section Checkpoint
  std::string inputs;     ///< size and checksum of the files that are named
};

/// Reads the files. @throws Error if one of them cannot be read.
RunIdentity identity_of(const dealii::ParameterHandler& all);

/// Names the first difference and what to do, as the begin of a sentence; empty if there is none.
/// `where` is where the one `then` was found.
std::string first_difference(const RunIdentity& then, const RunIdentity& now,
                             const std::string& where);

} // namespace prosup::pipeline

#endif
