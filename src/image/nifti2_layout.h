#ifndef PROSUP_SRC_IMAGE_NIFTI2_LAYOUT_H
#define PROSUP_SRC_IMAGE_NIFTI2_LAYOUT_H

#include <cstddef>
#include <cstdint>

namespace prosup::image {

/// A NIfTI-2 header as it is in a file; ITK comes with the layout of NIfTI-1 only (nifti1.h), whose
/// names the fields have. Standard: https://nifti.nimh.nih.gov/nifti-2
struct Nifti2Layout {
  std::int32_t sizeof_hdr;
  char magic[8];
  std::int16_t datatype, bitpix;
  std::int64_t dim[8];
  double intent_p1, intent_p2, intent_p3;
  double pixdim[8];
  std::int64_t vox_offset;
  double scl_slope, scl_inter;
  double cal_max, cal_min, slice_duration, toffset;
  std::int64_t slice_start, slice_end;
  char descrip[80], aux_file[24];
  std::int32_t qform_code, sform_code;
  double quatern_b, quatern_c, quatern_d, qoffset_x, qoffset_y, qoffset_z;
  double srow_x[4], srow_y[4], srow_z[4];
  std::int32_t slice_code, xyzt_units, intent_code;
  char intent_name[16], dim_info, unused[15];
};

/// Bytes of the header, without what the compiler may put behind it.
constexpr std::size_t nifti2_length = offsetof(Nifti2Layout, unused) + 15;

static_assert(offsetof(Nifti2Layout, dim) == 16 && offsetof(Nifti2Layout, vox_offset) == 168 &&
                  offsetof(Nifti2Layout, srow_z) == 464 && nifti2_length == 540,
              "nothing lies between the fields");

} // namespace prosup::image

#endif
