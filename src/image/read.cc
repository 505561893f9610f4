#include <itkImageFileReader.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "completeness.h"
#include "file_formats.h"
#include "itk_bridge.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/image_io.h"
#include "voxel_checks.h"

namespace prosup::image {

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
  if (io.GetNumberOfComponents() != n_components)
    throw Error(format("'%s' has %u values per voxel, but %u %s needed; give the right file.",
                       file.c_str(), io.GetNumberOfComponents(), n_components,
                       n_components == 1 ? "is" : "are"));
  for (unsigned d = 0; d < 3; ++d)
    if (!(io.GetSpacing(d) > 0.) || !std::isfinite(io.GetSpacing(d)))
      throw Error(format("'%s' has a voxel spacing of %g mm along axis %u, which must be positive; "
                         "correct its header.",
                         file.c_str(), io.GetSpacing(d), d));
}

template <typename T>
VoxelImage<T> read(const std::filesystem::path& path, Remarks& /*remarks*/) {
  const std::string file = path.string();
  const QuietItk quiet;
  const auto io = format_for_reading(path);
  constexpr unsigned n_components = sizeof(T) / sizeof(float);
  if (n_components > 1)
    refuse_nifti_vectors(*io, path);
  try {
    io->SetFileName(file);
    io->ReadImageInformation();
    check_header(*io, n_components, file);
    check_complete(*io, path);
    auto reader = itk::ImageFileReader<ItkImage<T>>::New();
    reader->SetImageIO(io);
    reader->SetFileName(file);
    reader->Update();
    const auto& output = *reader->GetOutput();
    const auto image = from_itk<T>(output, geometry(output));
    check_finite(image, path);
    return image;
  } catch (const itk::ExceptionObject& exception) {
    throw Error(format("'%s' cannot be read (%s); it may be damaged or incomplete.", file.c_str(),
                       one_line(exception.GetDescription()).c_str()));
  } catch (const std::domain_error& error) {
    throw Error(format("'%s' cannot be used: its %s; resample it to a regular grid.", file.c_str(),
                       error.what()));
  }
}

} // namespace

ScalarImage read_image(const std::filesystem::path& file, Remarks& remarks) {
  return read<float>(file, remarks);
}

ScalarImage read_image(const std::filesystem::path& file) {
  Remarks untold;
  return read_image(file, untold);
}

VectorImage read_displacement(const std::filesystem::path& file) {
  Remarks untold;
  return read<std::array<float, 3>>(file, untold);
}

LabelImage read_labels(const std::filesystem::path& file) {
  Remarks untold;
  return read_labels(file, untold);
}

LabelImage read_labels(const std::filesystem::path& file, Remarks& remarks) {
  const ScalarImage values = read_image(file, remarks);
  LabelImage labels(values.grid);
  for (std::size_t v = 0; v < values.values.size(); ++v) {
    const float value = values.values[v];
    if (value < 0.f || value > 255.f || value != std::floor(value)) {
      const Point<3> x = voxel_position(values.grid, v);
      throw Error(format("'%s' is no label image: it holds %g at LPS (%.1f, %.1f, %.1f) mm, but "
                         "labels are integers from 0 to 255; give the mask, not the image.",
                         file.string().c_str(), double(value), x[0], x[1], x[2]));
    }
    labels.values[v] = static_cast<std::uint8_t>(value);
  }
  return labels;
}

} // namespace prosup::image
