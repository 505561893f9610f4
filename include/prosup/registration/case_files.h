#ifndef PROSUP_REGISTRATION_CASE_FILES_H
#define PROSUP_REGISTRATION_CASE_FILES_H

#include <deal.II/base/tensor.h>

#include <string>

#include "prosup/core/position.h"
#include "prosup/unloading/support_parameters.h"

namespace prosup::registration {

/// What a registration is given of a case: files, and how the patient lay. No landmarks, which
/// serve the evaluation only.
struct CaseFiles {
  PerPosition<std::string> images; ///< of the loaded breasts: NIfTI, NRRD or MetaImage
  PerPosition<std::string> labels; ///< on the voxels of the images, see Labels
  /// Masks on the same voxels, not 0 where the image gives no force; may be empty.
  PerPosition<std::string> excluded;
  /// Directions of gravity, LPS, of any positive length.
  PerPosition<dealii::Tensor<1, 3>> gravity{dealii::Tensor<1, 3>({0., -1., 0.}),
                                            dealii::Tensor<1, 3>({0., 1., 0.})};
  dealii::Tensor<1, 3> supine_offset; ///< added to all supine coordinates as they are read, mm
  unloading::ChestCondition chest = unloading::ChestCondition::sliding;
};

} // namespace prosup::registration

#endif
