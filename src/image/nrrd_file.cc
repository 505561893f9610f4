#include "nrrd_file.h"

#include <algorithm>
#include <fstream>

namespace prosup::image {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t longest_header = 16u << 20; // bytes

} // namespace

NrrdHeader read_nrrd_header(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::min(longest_header, std::uintmax_t(fs::file_size(file))), '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(stream.gcount()));
  return parse_nrrd_header(text, file.string());
}

} // namespace prosup::image
