#include <itkImageFileWriter.h>
#include <itkNiftiImageIO.h>

#include <array>
#include <fstream>

#include "file_formats.h"
#include "itk_bridge.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text_file.h"
#include "prosup/image/image_io.h"
#include "volume.h"
#include "voxel_checks.h"

namespace prosup::image {

namespace {

/// Reads the written `file`, whose format tells its length only to readers.
void read_back(unsigned n_components, const std::filesystem::path& file) {
  try {
    Remarks untold;
    const FileFormat format = format_of(file);
    if (format == FileFormat::nifti)
      read_nifti(file, n_components, NiftiTransform::must_agree, untold);
    else if (format == FileFormat::meta_image)
      read_meta_image(file, n_components, untold);
    else
      read_nrrd(file, n_components, untold);
  } catch (const std::exception&) {
    throw_cannot_write(file);
  }
}

/// Makes sure that a file that `io` has written is whole: the libraries below ITK do not tell that
/// a disk is full. A compressed file ends with the length of what was compressed, modulo 2^32.
void check_written(const itk::ImageIOBase& io, const std::filesystem::path& file) {
  constexpr std::uintmax_t nifti_header = 352;
  const std::string ending = file.extension().string();
  if (ending != ".gz" && ending != ".nrrd")
    return read_back(io.GetNumberOfComponents(), file);
  const std::uintmax_t length =
      std::uintmax_t(io.GetImageSizeInBytes()) + (ending == ".gz" ? nifti_header : 0);
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 4> end{};
  stream.seekg(-4, std::ios::end).read(end.data(), end.size());
  std::uint32_t found = 0;
  for (unsigned i = 0; i < 4; ++i)
    found |= std::uint32_t(static_cast<unsigned char>(end[i])) << 8 * i;
  if (!stream || found != static_cast<std::uint32_t>(length))
    throw_cannot_write(file);
}

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
  } catch (const itk::ExceptionObject&) {
    throw_cannot_write(file);
  }
  check_written(*io, file);
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
  if (dynamic_cast<const itk::NiftiImageIO*>(io.GetPointer()) != nullptr)
    refuse_nifti_vectors(file);
  write(field, io, file);
}

} // namespace prosup::image
