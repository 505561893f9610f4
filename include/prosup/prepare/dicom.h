#ifndef PROSUP_PREPARE_DICOM_H
#define PROSUP_PREPARE_DICOM_H

#include <filesystem>

#include "prosup/core/log.h"
#include "prosup/core/position.h"
#include "prosup/core/remarks.h"
#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

/// Reads a series of slices from a folder of DICOM files, with ITK's GDCM. Files of other kinds are
/// passed over. Lists the series with number, description, modality, slices and voxel size, and
/// says which is taken: `series` by its number, or with 0 the one with most slices of those that
/// show at least 100 mm along all axes. Slices are put in order by their positions along the
/// normal; if there are several at a position, as in diffusion series, the first counts, which
/// `remarks` are told. Values have the rescale slope and intercept applied. Nothing that names the
/// patient is read.
/// @throws Error if the folder holds no such series, slices are missing or do not fit each other,
/// or if the patient lay otherwise than `position`.
image::ScalarImage read_dicom(const std::filesystem::path& folder, Position position,
                              unsigned series, const Log& log, Remarks& remarks);

} // namespace prosup::prepare

#endif
