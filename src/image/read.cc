#include <itkImageFileReader.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

#include "axis_order.h"
#include "file_formats.h"
#include "itk_bridge.h"
#include "nrrd_file.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/image_io.h"
#include "volume.h"
#include "voxel_checks.h"

namespace prosup::image {

namespace fs = std::filesystem;

namespace {

void check_header(const itk::ImageIOBase& io, unsigned n_components, const std::string& file) {
  const unsigned n_dimensions = io.GetNumberOfDimensions();
  unsigned n_extended = std::min(n_dimensions, 3u);
  for (unsigned d = 3; d < n_dimensions; ++d)
    n_extended += io.GetDimensions(d) > 1 ? 1 : 0;
  if (n_extended != 3)
    throw Error(format("'%s' has %u dimension%s, but a three-dimensional image is needed; "
                       "convert it to one volume.",
                       file.c_str(), n_extended, n_extended == 1 ? "" : "s"));
  check_components(io.GetNumberOfComponents(), n_components, file);
  for (unsigned d = 0; d < 3; ++d)
    if (!(io.GetSpacing(d) > 0.) || !std::isfinite(io.GetSpacing(d)))
      throw Error(format("'%s' has a voxel spacing of %g mm along axis %u, which must be positive; "
                         "correct its header.",
                         file.c_str(), io.GetSpacing(d), d));
}

template <typename T>
VoxelImage<T> read_by_itk(const fs::path& path, Remarks& remarks) {
  const std::string file = path.string();
  const QuietItk quiet;
  const auto io = nrrd_format();
  constexpr unsigned n_components = sizeof(T) / sizeof(float);
  try {
    const std::optional<NrrdPlace> place = check_nrrd(path, remarks);
    io->SetFileName(file);
    io->ReadImageInformation();
    check_header(*io, n_components, file);
    auto reader = itk::ImageFileReader<ItkImage<T>>::New();
    reader->SetImageIO(io);
    reader->SetFileName(file);
    reader->Update();
    auto& output = *reader->GetOutput();
    put(place, output);
    return from_itk<T>(output, geometry(output));
  } catch (const itk::ExceptionObject& exception) {
    throw Error(format("'%s' cannot be read (%s); it may be damaged or incomplete.", file.c_str(),
                       one_line(exception.GetDescription()).c_str()));
  }
}

VectorImage as_vectors(const Volume& volume) {
  VectorImage field(volume.grid);
  for (std::size_t v = 0; v < field.values.size(); ++v)
    std::copy_n(volume.values.data() + 3 * v, 3, field.values[v].data());
  return field;
}

/// Calls `work`, which reads `file`, and makes one sentence of what goes wrong.
template <typename Work>
auto in_words(const fs::path& file, const Work& work) {
  const std::string name = file.string();
  try {
    return work();
  } catch (const std::domain_error& error) {
    throw Error("'" + name + "' cannot be used: its " + error.what() +
                "; resample it to a regular grid.");
  } catch (const std::bad_alloc&) {
    throw Error("'" + name + "' needs more memory than there is; crop the image or resample it.");
  } catch (const fs::filesystem_error& error) {
    throw Error("'" + name + "' cannot be read (" + error.code().message() + "); copy it again.");
  }
}

/// Values, and the difference between those that are stored as neighbouring integers.
std::pair<ScalarImage, double> read_scalars(const fs::path& given, Remarks& remarks,
                                            NiftiTransform transform) {
  return in_words(given, [&] {
    const fs::path file = file_with_header(given);
    std::pair<ScalarImage, double> result;
    const FileFormat format = format_of(file);
    if (format == FileFormat::nrrd) {
      result.first = read_by_itk<float>(file, remarks);
    } else {
      Volume volume = format == FileFormat::nifti ? read_nifti(file, 1, transform, remarks)
                                                  : read_meta_image(file, 1, remarks);
      result.first.grid = volume.grid;
      result.first.values = std::move(volume.values);
      result.second = volume.step;
    }
    check_finite(result.first, file);
    result.first = in_usual_order(std::move(result.first));
    return result;
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
    VectorImage field = format == FileFormat::nrrd ? read_by_itk<std::array<float, 3>>(file, untold)
                                                   : as_vectors(read_meta_image(file, 3, untold));
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
