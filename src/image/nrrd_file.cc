#include "nrrd_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "nrrd_data.h"

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

std::optional<NrrdPlace> check_nrrd(const fs::path& file, Remarks& remarks) {
  const NrrdHeader header = read_nrrd_header(file);
  check_nrrd_data(header, file);
  return nrrd_place(header, file.string(), remarks);
}

void put(const std::optional<NrrdPlace>& place, itk::ImageBase<3>& image) {
  if (!place)
    return;
  itk::ImageBase<3>::PointType origin;
  itk::ImageBase<3>::SpacingType spacing;
  itk::ImageBase<3>::DirectionType direction;
  for (unsigned a = 0; a < 3; ++a) {
    const auto& step = place->step[a];
    origin[a] = place->origin[a];
    spacing[a] = std::hypot(step[0], step[1], step[2]);
    for (unsigned d = 0; d < 3; ++d)
      direction(d, a) = step[d] / spacing[a];
  }
  image.SetOrigin(origin);
  image.SetSpacing(spacing);
  image.SetDirection(direction);
}

} // namespace prosup::image
