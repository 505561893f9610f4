#include "prosup/core/file_system.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup {

namespace fs = std::filesystem;

namespace {

std::uint32_t checksum(const std::string& text) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
}

/// At most `n` bytes of a name, without a part of a character of UTF-8 at the end.
std::string first_bytes(const std::string& name, std::size_t n) {
  while (n > 0 && n < name.size() && (static_cast<unsigned char>(name[n]) & 0xC0) == 0x80)
    --n;
  return name.substr(0, n);
}

} // namespace

fs::path absolute_path(const fs::path& path) {
  std::error_code error;
  const fs::path result = fs::absolute(path, error);
  if (error)
    throw Error("The path '" + path.string() +
                "' cannot be found because the current folder is gone; change to a folder that "
                "exists or give a path that starts with '/'.");
  return result.lexically_normal();
}

void flush_to_disk(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool failed = descriptor < 0 || (fsync(descriptor) != 0 && errno != EINVAL);
  const std::string reason = std::strerror(errno);
  if (descriptor >= 0)
    close(descriptor);
  if (failed)
    throw Error("The file '" + file.string() + "' cannot be written to the disk (" + reason +
                "); check that there is space left.");
}

fs::path without_links(const fs::path& path) {
  constexpr unsigned most_links = 40; // as the kernel has it
  fs::path place = absolute_path(path);
  if (!place.has_filename())
    place = place.parent_path(); // a slash at the end
  std::error_code error;
  for (unsigned n = 0; fs::is_symlink(fs::symlink_status(place, error)); ++n) {
    if (n == most_links)
      throw Error("The links at '" + path.string() + "' lead in a circle; give another path.");
    place = (place.parent_path() / fs::read_symlink(place, error)).lexically_normal();
    if (!place.has_filename())
      place = place.parent_path();
  }
  const fs::path found = fs::weakly_canonical(place, error);
  return error ? place : found;
}

std::string unfinished_name(const fs::path& folder, const std::string& name,
                            const std::string& ending) {
  const std::string end = ".incomplete" + ending;
  const long limit = pathconf(folder.c_str(), _PC_NAME_MAX);
  const std::size_t longest = limit > 0 ? static_cast<std::size_t>(limit) : 255;
  if (1 + name.size() + end.size() <= longest)
    return "." + name + end;
  const std::string sum = format("-%08x", checksum(name));
  return "." + first_bytes(name, longest - 1 - sum.size() - end.size()) + sum + end;
}

bool same_file(const fs::path& one, const fs::path& other) {
  std::error_code error;
  return fs::exists(one, error) && fs::exists(other, error) && fs::equivalent(one, other, error) &&
         !error;
}

fs::path input_at(const fs::path& output, const std::vector<fs::path>& inputs) {
  for (const fs::path& input : inputs)
    if (!input.empty() && same_file(output, input))
      return input;
  return {};
}

} // namespace prosup
