#ifndef PROSUP_PIPELINE_STAGES_H
#define PROSUP_PIPELINE_STAGES_H

#include <filesystem>
#include <string>
#include <vector>

#include "prosup/core/labels.h"
#include "prosup/fdm/fdm_parameters.h"
#include "prosup/mechanics/body/element.h"
#include "prosup/mechanics/laws/tissue_material.h"
#include "prosup/mechanics/static/quasi_static.h"
#include "prosup/mesh/mask_mesher.h"
#include "prosup/phantom/phantom_parameters.h"
#include "prosup/pipeline/case_parameters.h"
#include "prosup/pipeline/comparison_parameters.h"
#include "prosup/pipeline/inputs.h"
#include "prosup/pipeline/result_parameters.h"
#include "prosup/pipeline/single_state_parameters.h"
#include "prosup/registration/image_force_registration.h"
#include "prosup/registration/material_update.h"
#include "prosup/registration/pre_alignment.h"
#include "prosup/similarity/similarity_parameters.h"
#include "prosup/unloading/support_parameters.h"
#include "prosup/unloading/unloading_parameters.h"

namespace prosup::pipeline {

/// All objects with parameters, in the order of the data. Every command has
/// them all, so that one parameter file serves every command.
struct Stages {
  CaseParameters scene;
  Labels labels;
  mesh::MaskMesher mesher{labels};
  InputReader inputs{labels};
  registration::PreAlignment pre_alignment;
  mechanics::ElementParameters elements;
  mechanics::TissueMaterial material{labels};
  unloading::SupportParameters supports;
  unloading::UnloadingParameters unloading;
  mechanics::QuasiStaticParameters quasi_static;
  fdm::FdmParameters fdm;
  SingleStateParameters single_state;
  similarity::SimilarityParameters similarity;
  registration::MaterialUpdate material_update;
  registration::ImageForceRegistration image_forces;
  ResultParameters results;
  phantom::PhantomParameters phantom;
  ComparisonParameters comparison;
};

} // namespace prosup::pipeline

#endif
