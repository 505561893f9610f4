#include "prosup/core/checksum.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>

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

std::string digest_text(const std::vector<std::filesystem::path>& files) {
  FileDigest all{0, static_cast<std::uint32_t>(crc32(0, nullptr, 0))};
  for (const std::filesystem::path& file : files) {
    const FileDigest next = digest_of(file);
    all.crc32 = static_cast<std::uint32_t>(
        crc32_combine(all.crc32, next.crc32, static_cast<z_off_t>(next.size)));
    all.size += next.size;
  }
  return format("%ju:%08x", all.size, all.crc32);
}

} // namespace prosup
