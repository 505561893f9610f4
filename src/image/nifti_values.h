#ifndef PROSUP_SRC_IMAGE_NIFTI_VALUES_H
#define PROSUP_SRC_IMAGE_NIFTI_VALUES_H

#include <array>
#include <cstdint>
#include <string>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/remarks.h"
#include "stored_values.h"

namespace prosup::image {

/// The sentences about the header of one file.
struct NiftiTeller {
  const std::string& file;
  Remarks& remarks;

  [[noreturn]] void refuse(const std::string& what,
                           const char* advice = "correct it or convert the image again") const {
    throw Error("The NIfTI header of '" + file + "' " + what + "; " + advice + ".");
  }
  void doubt(const std::string& what) const {
    remarks.add("The NIfTI header of '" + file + "' " + what + ".");
  }
};

/// The field dim with 1 for all axes that are not in use.
/// @throws Error unless it is that of one volume of three dimensions.
std::array<std::int64_t, 8> checked_dimensions(const std::array<std::int64_t, 8>& dim,
                                               const NiftiTeller& say);

/// Sets type and number of components from the fields datatype and bitpix.
/// @throws Error if prosup does not read such numbers.
void set_type(int datatype, int bits, StoredValues& values, const NiftiTeller& say);

/// Sets the scale from the fields scl_slope and scl_inter.
/// @throws Error if they give no voxel a value.
void set_scale(double slope, double intercept, StoredValues& values, const NiftiTeller& say);

} // namespace prosup::image

#endif
