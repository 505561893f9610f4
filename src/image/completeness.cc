#include "completeness.h"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <nifti1.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::image {

namespace {

namespace fs = std::filesystem;

void require_bytes(std::uintmax_t found, std::uintmax_t expected, const fs::path& file) {
  if (found < expected)
    throw Error(format("'%s' is damaged or incomplete: it holds %ju of %ju bytes; copy it again.",
                       file.string().c_str(), found, expected));
}

template <typename T>
T in_system_order(T value, bool swap) {
  auto* bytes = reinterpret_cast<unsigned char*>(&value);
  if (swap)
    std::reverse(bytes, bytes + sizeof(T));
  return value;
}

/// Length of a NIfTI file before compression, as its header has it.
std::uintmax_t nifti_length(const nifti_1_header& header) {
  const bool swap = header.sizeof_hdr != int(sizeof(nifti_1_header));
  std::uintmax_t n_voxels = 1;
  for (int d = 1; d <= std::min<int>(in_system_order(header.dim[0], swap), 7); ++d)
    n_voxels *= std::uintmax_t(std::max<int>(in_system_order(header.dim[d], swap), 1));
  // 0 comes first so that it is taken if the offset is not a number.
  const float offset = std::max(0.f, in_system_order(header.vox_offset, swap));
  const int bits = std::max<int>(in_system_order(header.bitpix, swap), 0);
  return std::uintmax_t(std::min(offset, 1e9f)) + n_voxels * std::uintmax_t(bits) / 8;
}

void check_nifti(const fs::path& file) {
  // Reads plain and compressed files alike, and compares the checksum.
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> stream(gzopen(file.c_str(), "rb"), gzclose);
  nifti_1_header header{};
  std::uintmax_t found = 0;
  if (stream && gzread(stream.get(), &header, sizeof(header)) == int(sizeof(header))) {
    found = sizeof(header);
    std::vector<unsigned char> buffer(1u << 18);
    int n_read = 0;
    while ((n_read = gzread(stream.get(), buffer.data(), unsigned(buffer.size()))) > 0)
      found += unsigned(n_read);
    if (n_read == 0)
      return require_bytes(found, nifti_length(header), file);
  }
  throw Error(format("'%s' is damaged or incomplete: its data end after %ju bytes; copy it again.",
                     file.string().c_str(), found));
}

std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The value of a MetaImage header line "key = value"; empty if it has another
/// key.
std::string value_of(const std::string& line, const std::string& key) {
  const std::size_t separator = line.find_first_of("=:");
  if (separator == std::string::npos || trimmed(line.substr(0, separator)) != key)
    return {};
  return trimmed(line.substr(separator + 1));
}

void check_data_file(const fs::path& data, std::uintmax_t expected, const fs::path& header) {
  if (!fs::is_regular_file(data))
    throw Error(format("'%s' names '%s' as the file of its voxels, which does not exist; copy it "
                       "too.",
                       header.string().c_str(), data.string().c_str()));
  require_bytes(fs::file_size(data), expected, data);
}

void check_meta(const itk::ImageIOBase& io, const fs::path& file) {
  std::uintmax_t expected = std::uintmax_t(io.GetImageSizeInBytes());
  std::ifstream in(file, std::ios::binary);
  for (std::string line; std::getline(in, line);) {
    if (value_of(line, "BinaryData") == "False")
      return; // text: its length does not follow from the number of voxels
    const std::string compressed = value_of(line, "CompressedDataSize");
    if (!compressed.empty())
      expected = std::strtoull(compressed.c_str(), nullptr, 10);
    const std::string data = value_of(line, "ElementDataFile");
    if (data == "LOCAL" || data == "Local" || data == "local") {
      const std::uintmax_t size = fs::file_size(file);
      return require_bytes(size, (in.eof() ? size : std::uintmax_t(in.tellg())) + expected, file);
    }
    if (data.compare(0, 4, "LIST") == 0 || data.find('%') != std::string::npos)
      return; // one file per slice, which are read one by one
    if (!data.empty())
      return check_data_file(file.parent_path() / data, expected, file);
  }
}

} // namespace

void check_complete(const itk::ImageIOBase& io, const fs::path& file) {
  if (dynamic_cast<const itk::NiftiImageIO*>(&io) != nullptr)
    check_nifti(file);
  else if (dynamic_cast<const itk::MetaImageIO*>(&io) != nullptr)
    check_meta(io, file);
}

} // namespace prosup::image
