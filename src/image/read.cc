#include <algorithm>
#include <cmath>

#include "axis_order.h"
#include "file_formats.h"
#include "in_words.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/image_io.h"
#include "volume.h"
#include "voxel_checks.h"

namespace prosup::image {

namespace fs = std::filesystem;

namespace {

VectorImage as_vectors(const Volume& volume) {
  VectorImage field(volume.grid);
  for (std::size_t v = 0; v < field.values.size(); ++v)
    std::copy_n(volume.values.data() + 3 * v, 3, field.values[v].data());
  return field;
}

/// Values, and the difference between those that are stored as neighbouring integers.
std::pair<ScalarImage, double> read_scalars(const fs::path& given, Remarks& remarks,
                                            NiftiTransform transform) {
  return in_words(given, [&] {
    const fs::path file = file_with_header(given);
    const FileFormat format = format_of(file);
    Volume volume = format == FileFormat::nifti  ? read_nifti(file, 1, transform, remarks)
                    : format == FileFormat::nrrd ? read_nrrd(file, 1, remarks)
                                                 : read_meta_image(file, 1, remarks);
    ScalarImage image;
    image.grid = volume.grid;
    image.values = std::move(volume.values);
    check_finite(image, file);
    return std::pair(in_usual_order(std::move(image)), volume.step);
  });
}

} // namespace

void check_components(unsigned found, unsigned needed, const fs::path& file) {
  if (found != needed)
    throw Error(format("'%s' has %u values per voxel, but %u %s needed; give the right file.",
                       file.string().c_str(), found, needed, needed == 1 ? "is" : "are"));
}

ScalarImage read_image(const fs::path& file, Remarks& remarks, NiftiTransform transform) {
  return read_scalars(file, remarks, transform).first;
}

ScalarImage read_image(const fs::path& file) {
  Remarks untold;
  return read_image(file, untold);
}

VectorImage read_displacement(const fs::path& file) {
  return in_words(file, [&] {
    Remarks untold;
    const FileFormat format = format_of(file);
    if (format == FileFormat::nifti)
      refuse_nifti_vectors(file);
    const VectorImage field = as_vectors(
        format == FileFormat::nrrd ? read_nrrd(file, 3, untold) : read_meta_image(file, 3, untold));
    check_finite(field, file);
    return field;
  });
}

LabelImage read_labels(const fs::path& file) {
  Remarks untold;
  return read_labels(file, untold);
}

LabelImage read_labels(const fs::path& file, Remarks& remarks, NiftiTransform transform) {
  const auto [values, step] = read_scalars(file, remarks, transform);
  return rounded_labels(values, step, file, remarks);
}

} // namespace prosup::image
