#ifndef PROSUP_SRC_IMAGE_NIFTI_HEADER_H
#define PROSUP_SRC_IMAGE_NIFTI_HEADER_H

#include <array>
#include <cstdint>
#include <string>

#include "prosup/core/remarks.h"
#include "stored_values.h"

namespace prosup::image {

/// What prosup needs of a NIfTI-1 or NIfTI-2 header.
/// Standard: https://nifti.nimh.nih.gov/nifti-1 and nifti-2, with the comments of nifti1.h.
struct NiftiHeader {
  int version = 1;
  bool pair = false;        ///< the voxels are in a file of their own (.img)
  std::uint64_t offset = 0; ///< of the voxels in their file, bytes
  std::array<std::size_t, 3> size{};
  StoredValues values;

  int qform_code = 0, sform_code = 0; ///< 0: there is none
  double qfac = 1.;
  std::array<double, 3> pixdim{};                ///< voxel size, in the unit of the file
  std::array<double, 3> quaternion{}, qoffset{}; ///< b, c, d; x, y, z
  std::array<std::array<double, 4>, 3> sform{};  ///< rows of the matrix
  double millimetres = 1.;                       ///< of the unit of the file
};

/// Bytes of the longer of the two kinds of header; parse_nifti_header() looks at no more.
constexpr std::size_t longest_nifti_header = 540;

/// Whether a file that begins so, once unpacked, is NIfTI or its forerunner Analyze.
bool is_nifti(const unsigned char* bytes, std::size_t n_bytes);

/// Reads the first bytes of a file that is_nifti(), for one volume. What is doubtful goes to
/// `remarks`.
/// @throws Error that names `file` if the header contradicts the standard or itself, or is that of
/// something else than one volume.
NiftiHeader parse_nifti_header(const unsigned char* bytes, std::size_t n_bytes,
                               const std::string& file, Remarks& remarks);

} // namespace prosup::image

#endif
