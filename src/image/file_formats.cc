#include "file_formats.h"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <array>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::image {

namespace {

constexpr const char* known_formats =
    "NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr) or MetaImage (.mha, .mhd)";

std::array<itk::ImageIOBase::Pointer, 3> all_formats() {
  auto nifti = itk::NiftiImageIO::New();
  // An Analyze file has no orientation: left and right could be swapped.
  nifti->SetLegacyAnalyze75Mode(itk::NiftiImageIOEnums::Analyze75Flavor::AnalyzeReject);
  return {itk::ImageIOBase::Pointer(nifti), itk::ImageIOBase::Pointer(itk::NrrdImageIO::New()),
          itk::ImageIOBase::Pointer(itk::MetaImageIO::New())};
}

} // namespace

itk::ImageIOBase::Pointer format_for_reading(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw Error(format("The image file '%s' does not exist; check the path.", name.c_str()));
  if (!std::filesystem::is_regular_file(file, ignored))
    throw Error(format("'%s' is not a file; give an image file: %s.", name.c_str(), known_formats));
  const bool half_of_a_pair = file.extension() == ".hdr" || file.extension() == ".img";
  for (const auto& io : all_formats())
    if (!half_of_a_pair && io->CanReadFile(name.c_str()))
      return io;
  throw Error(format("'%s' is in no image format that can be read; convert it to %s.", name.c_str(),
                     known_formats));
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

void refuse_nifti_vectors(const itk::ImageIOBase& io, const std::filesystem::path& file) {
  if (dynamic_cast<const itk::NiftiImageIO*>(&io) != nullptr)
    throw Error(format("'%s' is NIfTI, but displacement fields are NRRD (.nrrd) or MetaImage "
                       "(.mha), because tools disagree on the vectors of NIfTI.",
                       file.string().c_str()));
}

std::string one_line(const std::string& text) {
  // "ITK ERROR: NrrdImageIO(0x5639cfe45eb0): ..." names an object in memory.
  const std::size_t object = text.find("ERROR: ") < 8 ? text.find("): ") : std::string::npos;
  std::string line;
  for (const char c : object == std::string::npos ? text : text.substr(object + 3)) {
    const bool blank = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!blank)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  while (!line.empty() && (line.back() == ' ' || line.back() == '.'))
    line.pop_back();
  // The text becomes part of one sentence.
  for (std::size_t stop = 0; (stop = line.find(". ", stop)) != std::string::npos;)
    line[stop] = ';';
  return line;
}

QuietItk::QuietItk() : before_(itk::Object::GetGlobalWarningDisplay()) {
  itk::Object::SetGlobalWarningDisplay(false);
}

QuietItk::~QuietItk() {
  itk::Object::SetGlobalWarningDisplay(before_);
}

} // namespace prosup::image
