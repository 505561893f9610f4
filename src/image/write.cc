#include <itkImageFileWriter.h>

#include "file_formats.h"
#include "itk_bridge.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/image_io.h"
#include "voxel_checks.h"

namespace prosup::image {

namespace {

template <typename T>
void write(const VoxelImage<T>& image, const itk::ImageIOBase::Pointer& io,
           const std::filesystem::path& file) {
  const QuietItk quiet;
  const auto view = as_itk(image);
  auto writer = itk::ImageFileWriter<ItkImage<T>>::New();
  writer->SetImageIO(io);
  writer->SetFileName(file.string());
  writer->SetInput(view);
  writer->SetUseCompression(true);
  try {
    writer->Update();
  } catch (const itk::ExceptionObject& exception) {
    throw Error(format("'%s' cannot be written (%s); check permissions and free space.",
                       file.string().c_str(), one_line(exception.GetDescription()).c_str()));
  }
}

} // namespace

void write_image(const ScalarImage& image, const std::filesystem::path& file) {
  check_finite(image, file);
  write(image, format_for_writing(file), file);
}

void write_labels(const LabelImage& image, const std::filesystem::path& file) {
  write(image, format_for_writing(file), file);
}

void write_displacement(const VectorImage& field, const std::filesystem::path& file) {
  check_finite(field, file);
  const auto io = format_for_writing(file);
  refuse_nifti_vectors(*io, file);
  write(field, io, file);
}

} // namespace prosup::image
