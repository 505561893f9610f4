#ifndef PROSUP_CORE_CHECKSUM_H
#define PROSUP_CORE_CHECKSUM_H

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace prosup {

/// Size and CRC-32 (ISO 3309, that of zlib and gzip) of a file: equal ones mean that nobody has
/// changed it.
struct FileDigest {
  std::uintmax_t size = 0;
  std::uint32_t crc32 = 0;

  bool operator==(const FileDigest& other) const {
    return size == other.size && crc32 == other.crc32;
  }
};

/// Of the first `n_bytes` of a file, or of all of it. @throws Error if the file cannot be read.
FileDigest digest_of(const std::filesystem::path& file, std::uintmax_t n_bytes = UINTMAX_MAX);

/// The digest of files, one behind the other, as text, "1234:89abcdef".
/// @throws Error if one of them cannot be read.
std::string digest_text(const std::vector<std::filesystem::path>& files);

} // namespace prosup

#endif
