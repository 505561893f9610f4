#include "prosup/core/checksum.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup {

namespace {

struct Checked {
  std::uint32_t sum;
  std::uintmax_t n_bytes;
};

Checked check(const std::filesystem::path& file, std::uintmax_t n_bytes) {
  std::ifstream stream(file, std::ios::binary);
  std::vector<char> block(1 << 20);
  Checked found{static_cast<std::uint32_t>(crc32(0, nullptr, 0)), 0};
  while (stream && found.n_bytes < n_bytes) {
    stream.read(block.data(), static_cast<std::streamsize>(
                                  std::min<std::uintmax_t>(block.size(), n_bytes - found.n_bytes)));
    const auto n = static_cast<uInt>(stream.gcount());
    found.sum = static_cast<std::uint32_t>(
        crc32(found.sum, reinterpret_cast<const Bytef*>(block.data()), n));
    found.n_bytes += n;
  }
  if (!stream.is_open() || stream.bad())
    throw Error("The file '" + file.string() +
                "' cannot be read; check that it exists and may be read.");
  return found;
}

} // namespace

std::uint32_t checksum(const std::filesystem::path& file, std::uintmax_t n_bytes) {
  return check(file, n_bytes).sum;
}

std::string digest(const std::filesystem::path& file) {
  if (file.empty())
    return "";
  const Checked found = check(file, UINTMAX_MAX);
  return format("%llu:%08x", static_cast<unsigned long long>(found.n_bytes), found.sum);
}

} // namespace prosup
