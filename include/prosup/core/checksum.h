#ifndef PROSUP_CORE_CHECKSUM_H
#define PROSUP_CORE_CHECKSUM_H

#include <cstdint>
#include <filesystem>
#include <string>

namespace prosup {

/// CRC-32 (ISO 3309, that of zlib and gzip) of the first `n_bytes` of a file, or of all of it.
/// @throws Error if the file cannot be read.
std::uint32_t checksum(const std::filesystem::path& file, std::uintmax_t n_bytes = UINTMAX_MAX);

/// What tells the contents of a file from others: size and CRC-32, "1234:89abcdef". Empty for an
/// empty name. @throws Error if the file cannot be read.
std::string digest(const std::filesystem::path& file);

} // namespace prosup

#endif
