#ifndef PROSUP_PIPELINE_ALL_PARAMETERS_H
#define PROSUP_PIPELINE_ALL_PARAMETERS_H

#include "prosup/mechanics/static/quasi_static.h"
#include "prosup/phantom/phantom_parameters.h"
#include "prosup/pipeline/case_parameters.h"
#include "prosup/pipeline/checkpoint_parameters.h"
#include "prosup/pipeline/comparison_parameters.h"
#include "prosup/pipeline/result_parameters.h"
#include "prosup/pipeline/scan_parameters.h"
#include "prosup/pipeline/single_state_parameters.h"
#include "prosup/prepare/preparation.h"
#include "prosup/registration/registration.h"

namespace prosup::pipeline {

/// All sections of a parameter file. Every command has them all, so that one file serves every
/// command.
struct AllParameters {
  CaseParameters case_files;
  registration::RegistrationParameters registration;
  mechanics::QuasiStaticParameters quasi_static;
  SingleStateParameters single_state;
  ResultParameters results;
  CheckpointParameters checkpoint;
  phantom::PhantomParameters phantom;
  ComparisonParameters comparison;
  ScanParameters scans;
  prepare::Preparation preparation{registration.labels};

  const registration::BreastModel& model() const { return registration.model; }
};

} // namespace prosup::pipeline

#endif
