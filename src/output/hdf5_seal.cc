#include "hdf5_seal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "prosup/core/checksum.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::output {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t seal_length = 23;

std::string seal_of(std::uint32_t sum) {
  return format("\nprosup crc32 %08x\n", sum);
}

} // namespace

void seal(const fs::path& file) {
  const std::string text = seal_of(digest_of(file).crc32);
  const int descriptor = open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  bool written = descriptor >= 0 &&
                 write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
                 fsync(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0)
    written = close(descriptor) == 0 && written;
  if (!written)
    throw Error("The file '" + file.string() + "' cannot be written (" + std::strerror(error) +
                "); check the free space of its disk.");
}

bool is_whole(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || size < seal_length)
    return false;
  std::string text(seal_length, ' ');
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(size - seal_length));
  stream.read(text.data(), seal_length);
  return stream && text == seal_of(digest_of(file, size - seal_length).crc32);
}

void synchronize_folder(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    return;
  fsync(descriptor);
  close(descriptor);
}

} // namespace prosup::output
