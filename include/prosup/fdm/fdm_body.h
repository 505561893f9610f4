#ifndef PROSUP_FDM_FDM_BODY_H
#define PROSUP_FDM_FDM_BODY_H

#include <deal.II/base/tensor.h>

#include "prosup/core/units.h"
#include "prosup/fdm/chest_condition.h"
#include "prosup/fdm/material.h"
#include "prosup/image/voxel_image.h"

namespace prosup::fdm {

/// What the finite-difference method has to know of a breast.
struct FdmBody {
  /// The loaded image. Labels that are neither the chest's nor in the material are air.
  const image::LabelImage& labels;
  unsigned chest_label = 1;
  Material material;
  dealii::Tensor<1, 3> gravity; ///< acceleration in LPS, mm/s^2
  ChestCondition chest{};
  double density = tissue_density; ///< rho, g/mm^3, of all tissues
};

} // namespace prosup::fdm

#endif
