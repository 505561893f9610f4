#ifndef PROSUP_EVALUATION_FIELD_ERROR_H
#define PROSUP_EVALUATION_FIELD_ERROR_H

#include <vector>

#include "prosup/evaluation/landmarks.h"
#include "prosup/evaluation/target_registration_error.h"
#include "prosup/image/voxel_image.h"

namespace prosup::evaluation {

/// Distances |p + d(p) - s| of the supine landmarks s from where a displacement field
/// d, mm, carries the prone ones p; the field is that of any method, and interpolated
/// linearly between its voxels.
/// @throws Error if there is no landmark, or the field is not finite at one.
ErrorStatistics field_error(const std::vector<Landmark>& landmarks,
                            const image::VectorImage& prone_to_supine);

/// How a map x + d(x) changes volume in a mask.
struct FieldJacobian {
  double min = 1.;
  double folded_fraction = 0.; ///< of the voxels, where J <= 0
};

/// J = det(1 + grad d) by central differences of the voxels, at those of `mask` that are
/// not 0 and have neighbours on all sides.
/// @throws Error if the mask has no such voxel or is not on the voxels of the field.
FieldJacobian field_jacobian(const image::VectorImage& displacement, const image::LabelImage& mask);

} // namespace prosup::evaluation

#endif
