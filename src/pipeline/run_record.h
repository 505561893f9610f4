#ifndef PROSUP_SRC_PIPELINE_RUN_RECORD_H
#define PROSUP_SRC_PIPELINE_RUN_RECORD_H

#include <string>
#include <vector>

#include "prosup/output/convergence.h"
#include "prosup/output/summary.h"
#include "prosup/registration/quality.h"

namespace prosup::pipeline {

/// What a registration has told of itself so far, as JSON, for a run that goes on in another
/// process: alignment, steps, similarities, agreement, errors and times of the stages.
std::string record_of(const output::Summary& summary, const registration::Quality& quality,
                      const std::vector<output::ConvergenceEntry>& convergence);
/// Sets these again. @throws Error if the text is no such record.
void set_record(const std::string& text, output::Summary& summary, registration::Quality& quality,
                std::vector<output::ConvergenceEntry>& convergence);

} // namespace prosup::pipeline

#endif
