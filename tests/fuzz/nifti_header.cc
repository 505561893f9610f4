#include "image/nifti_header.h"

#include "fuzz_target.h"
#include "image/nifti_grid.h"

namespace prosup::tests {

/// The first bytes of a NIfTI file; the last byte chooses the transform that counts.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using image::NiftiTransform;
  if (size == 0 || !image::is_nifti(data, size))
    return 0;
  const NiftiTransform transforms[] = {NiftiTransform::must_agree, NiftiTransform::sform,
                                       NiftiTransform::qform};
  Remarks remarks;
  parse_or_refuse([&] {
    const auto header = image::parse_nifti_header(data, size, "image.nii", remarks);
    image::nifti_grid(header, transforms[data[size - 1] % 3], "image.nii", remarks);
  });
  require_sentences(remarks);
  return 0;
}

} // namespace prosup::tests
