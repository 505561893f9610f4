#include "file_formats.h"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <array>
#include <vector>

#include "byte_source.h"
#include "meta_header.h"
#include "nifti_header.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::image {

namespace {

constexpr const char* known_formats =
    "NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr) or MetaImage (.mha, .mhd)";

std::array<itk::ImageIOBase::Pointer, 3> all_formats() {
  return {itk::ImageIOBase::Pointer(itk::NiftiImageIO::New()),
          itk::ImageIOBase::Pointer(itk::NrrdImageIO::New()),
          itk::ImageIOBase::Pointer(itk::MetaImageIO::New())};
}

} // namespace

FileFormat format_of(const std::filesystem::path& file) {
  constexpr std::size_t longest_beginning = 1u << 16; // a MetaImage may begin with long comments
  const std::string name = file.string();
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw Error(format("The image file '%s' does not exist; check the path.", name.c_str()));
  if (!std::filesystem::is_regular_file(file, ignored))
    throw Error(format("'%s' is not a file; give an image file: %s.", name.c_str(), known_formats));
  std::vector<unsigned char> bytes(longest_beginning);
  bytes.resize(unpacked_bytes(file)->read(bytes.data(), bytes.size()));
  if (bytes.empty())
    throw Error("'" + name + "' is empty; copy it again.");
  if (is_nifti(bytes.data(), bytes.size()))
    return FileFormat::nifti;
  const std::string text(bytes.begin(), bytes.end());
  if (text.compare(0, 4, "NRRD") == 0)
    return FileFormat::nrrd;
  if (is_meta_image(text))
    return FileFormat::meta_image;
  throw Error(format("'%s' is in no image format that can be read; convert it to %s.", name.c_str(),
                     known_formats));
}

std::filesystem::path file_with_header(const std::filesystem::path& file) {
  std::filesystem::path header = file;
  if (header.extension() == ".gz")
    header.replace_extension();
  if (header.extension() != ".img")
    return file;
  header.replace_extension(".hdr");
  for (const char* ending : {"", ".gz"})
    if (const std::filesystem::path candidate = header.string() + ending;
        std::filesystem::is_regular_file(candidate))
      return candidate;
  return file;
}

itk::ImageIOBase::Pointer format_for_writing(const std::filesystem::path& file) {
  const std::string name = file.string();
  const auto folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder))
    throw Error(format("'%s' cannot be written: its folder does not exist; create it first.",
                       name.c_str()));
  for (const auto& io : all_formats())
    if (io->CanWriteFile(name.c_str()))
      return io;
  throw Error(format("'%s' cannot be written: its extension is not one of %s.", name.c_str(),
                     known_formats));
}

void refuse_nifti_vectors(const std::filesystem::path& file) {
  throw Error(format("'%s' is NIfTI, but displacement fields are NRRD (.nrrd) or MetaImage "
                     "(.mha), because tools disagree on the vectors of NIfTI.",
                     file.string().c_str()));
}

QuietItk::QuietItk() : before_(itk::Object::GetGlobalWarningDisplay()) {
  itk::Object::SetGlobalWarningDisplay(false);
}

QuietItk::~QuietItk() {
  itk::Object::SetGlobalWarningDisplay(before_);
}

} // namespace prosup::image
