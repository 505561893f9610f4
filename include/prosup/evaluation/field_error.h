#ifndef PROSUP_EVALUATION_FIELD_ERROR_H
#define PROSUP_EVALUATION_FIELD_ERROR_H

#include <vector>

#include "prosup/evaluation/landmarks.h"
#include "prosup/evaluation/target_registration_error.h"
#include "prosup/image/voxel_image.h"

namespace prosup::evaluation {

/// Statistics of the distances |p + d(p) - s| between supine landmarks s and the prone
/// landmarks p, moved by the displacement field d, mm, of any method. The field is
/// interpolated linearly between voxels.
/// @throws Error if there is no landmark, or if the field is not finite at a landmark.
ErrorStatistics field_error(const std::vector<Landmark>& landmarks,
                            const image::VectorImage& prone_to_supine);

/// Changes of volume by a map x + d(x) within a mask.
struct FieldJacobian {
  double min = 1.;
  double folded_fraction = 0.; ///< fraction of voxels with J <= 0
};

/// J = det(1 + grad d) by central differences, at the voxels where `mask` is not 0 and that
/// have neighbours on all sides.
/// @throws Error if there is no such voxel, or if the mask does not have the voxels of the
/// field.
FieldJacobian field_jacobian(const image::VectorImage& displacement, const image::LabelImage& mask);

} // namespace prosup::evaluation

#endif
