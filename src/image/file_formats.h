#ifndef PROSUP_SRC_IMAGE_FILE_FORMATS_H
#define PROSUP_SRC_IMAGE_FILE_FORMATS_H

#include <itkImageIOBase.h>

#include <filesystem>
#include <string>

namespace prosup::image {

// Readers and writers are made by hand rather than through ITK's factories,
// which are shared by the whole process and belong to the host program.

enum class FileFormat { nifti, nrrd, meta_image };

/// The format of `file` by what is in it, whatever its name.
/// @throws Error if the file is missing or of no known format.
FileFormat format_of(const std::filesystem::path& file);

/// The file to begin with: the header if `file` is the other half of a pair (.hdr, .img), or
/// `file`.
std::filesystem::path file_with_header(const std::filesystem::path& file);

/// The writer for the ending of the file name.
/// @throws Error if the ending is unknown or the folder does not exist.
itk::ImageIOBase::Pointer format_for_writing(const std::filesystem::path& file);

/// @throws Error about a displacement field `file` in NIfTI, whose vectors mean different things to
/// different tools.
[[noreturn]] void refuse_nifti_vectors(const std::filesystem::path& file);

/// Silences ITK's warnings while it lives.
class QuietItk {
public:
  QuietItk();
  ~QuietItk();
  QuietItk(const QuietItk&) = delete;
  QuietItk& operator=(const QuietItk&) = delete;

private:
  bool before_;
};

} // namespace prosup::image

#endif
