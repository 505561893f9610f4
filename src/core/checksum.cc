#include "prosup/core/checksum.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup {

FileDigest digest_of(const std::filesystem::path& file, std::uintmax_t n_bytes) {
  std::ifstream stream(file, std::ios::binary);
  std::vector<char> block(1u << 20);
  FileDigest found{0, static_cast<std::uint32_t>(crc32(0, nullptr, 0))};
  while (stream && found.size < n_bytes) {
    stream.read(block.data(), static_cast<std::streamsize>(
                                  std::min<std::uintmax_t>(block.size(), n_bytes - found.size)));
    const auto n = static_cast<uInt>(stream.gcount());
    found.crc32 = static_cast<std::uint32_t>(
        crc32(found.crc32, reinterpret_cast<const Bytef*>(block.data()), n));
    found.size += n;
  }
  if (!stream.is_open() || stream.bad() || (stream.fail() && !stream.eof()))
    throw Error("The file '" + file.string() +
                "' cannot be read; check that it exists and may be read.");
  return found;
}

std::string digest_text(const std::filesystem::path& file) {
  if (file.empty())
    return "";
  const FileDigest found = digest_of(file);
  return format("%ju:%08x", found.size, found.crc32);
}

} // namespace prosup
