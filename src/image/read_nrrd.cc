#include <NrrdIO.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "nrrd_data.h"
#include "nrrd_file.h"
#include "prosup/core/error.h"
#include "prosup/core/exception_text.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "regular_grid.h"
#include "stored_values.h"
#include "volume.h"
#include "voxel_checks.h"

namespace prosup::image {

namespace fs = std::filesystem;

namespace {

/// Which axes of the array are those of space: three in turn. Another one may hold the values of a
/// voxel.
struct Axes {
  std::size_t first = 0;
  std::optional<std::size_t> values;
};

/// Whether the kind of an axis says that it is neither one of space nor of time.
bool holds_values(const NrrdHeader& header, std::size_t axis) {
  std::istringstream kinds(lower_case(header.field("kinds")));
  std::string kind;
  for (std::size_t a = 0; a <= axis; ++a)
    if (!(kinds >> kind))
      return false;
  const char* const others[] = {"domain", "space", "time", "???", "none"};
  return std::none_of(std::begin(others), std::end(others),
                      [&](const char* other) { return kind == other; });
}

Axes axes_of(const NrrdHeader& header, const std::string& file) {
  const auto& axes = header.axes;
  const bool is_placed = std::any_of(axes.begin(), axes.end(),
                                     [](const auto& axis) { return axis.direction.has_value(); });
  Axes result;
  if (axes.size() > 3 && (is_placed ? !axes[0].direction : holds_values(header, 0)))
    result = {1, 0};
  const std::size_t end = result.first + 3;
  if (axes.size() < end)
    throw Error(format("'%s' has %zu dimension%s, but a three-dimensional image is needed; convert "
                       "it to one volume.",
                       file.c_str(), axes.size(), axes.size() == 1 ? "" : "s"));
  for (std::size_t a = result.first; is_placed && a < end; ++a)
    if (!axes[a].direction)
      refuse_nrrd_header(file, "has an axis without a direction between those of space");
  for (std::size_t a = end; a < axes.size(); ++a)
    if (axes[a].size > 1 && !result.values && holds_values(header, a))
      result.values = a;
    else if (axes[a].size > 1)
      throw Error(format("'%s' has %zu dimensions, with %zu volumes one after the other, but a "
                         "three-dimensional image is needed; extract the volume that is meant.",
                         file.c_str(), a + 1, axes[a].size));
  return result;
}

/// What the library says went wrong, as a part of a sentence.
std::string last_mistake() {
  char* const message = biffGetDone(NRRD);
  std::string line = on_one_line(message == nullptr ? "" : message);
  std::free(message);
  // It tells the way that the mistake took; the last is the mistake.
  if (const std::size_t last = line.rfind("[nrrd] "); last != std::string::npos)
    line.erase(0, last + 7);
  while (!line.empty() && line.back() == '.')
    line.pop_back();
  for (std::size_t stop = 0; (stop = line.find(". ", stop)) != std::string::npos;)
    line[stop] = ';';
  return line;
}

using Data = std::unique_ptr<Nrrd, Nrrd* (*)(Nrrd*)>;

/// The whole array in the byte order of this machine, read by the library that ITK has. ITK's own
/// class refuses a fourth axis of one volume.
Data load(const fs::path& file) {
  Data data(nrrdNew(), nrrdNuke);
  if (data && nrrdLoad(data.get(), file.c_str(), nullptr) == 0)
    return data;
  throw Error("'" + file.string() + "' cannot be read (" + last_mistake() +
              "); it may be damaged or incomplete.");
}

NumberType type_of(const Nrrd& data, const std::string& file) {
  switch (data.type) {
  case nrrdTypeChar:
    return NumberType::int8;
  case nrrdTypeUChar:
    return NumberType::uint8;
  case nrrdTypeShort:
    return NumberType::int16;
  case nrrdTypeUShort:
    return NumberType::uint16;
  case nrrdTypeInt:
    return NumberType::int32;
  case nrrdTypeUInt:
    return NumberType::uint32;
  case nrrdTypeLLong:
    return NumberType::int64;
  case nrrdTypeULLong:
    return NumberType::uint64;
  case nrrdTypeFloat:
    return NumberType::float32;
  case nrrdTypeDouble:
    return NumberType::float64;
  default:
    refuse_nrrd_header(file, "has blocks of bytes in place of numbers");
  }
}

/// Where a header with spacings alone puts the voxels.
VoxelSteps by_spacings(const Nrrd& data, const Axes& axes, const std::string& file) {
  VoxelSteps place;
  for (unsigned d = 0; d < 3; ++d) {
    const NrrdAxisInfo& axis = data.axis[axes.first + d];
    if (!(axis.spacing > 0.) || !std::isfinite(axis.spacing))
      throw Error(format("'%s' has a voxel spacing of %g mm along axis %u, which must be positive; "
                         "correct its header.",
                         file.c_str(), axis.spacing, d));
    place.steps[d][d] = axis.spacing;
    place.origin[d] = std::isfinite(axis.min) ? axis.min : 0.;
  }
  return place;
}

VoxelSteps steps_of(const NrrdPlace& place) {
  VoxelSteps result;
  for (unsigned d = 0; d < 3; ++d) {
    result.origin[d] = place.origin[d];
    for (unsigned e = 0; e < 3; ++e)
      result.steps[d][e] = place.step[d][e];
  }
  return result;
}

} // namespace

Volume read_nrrd(const fs::path& path, unsigned n_components, Remarks& remarks) {
  const std::string file = path.string();
  const NrrdHeader header = read_nrrd_header(path);
  check_nrrd_data(header, path);
  const std::optional<NrrdPlace> place = nrrd_place(header, file, remarks);
  const Axes axes = axes_of(header, file);
  const std::size_t n_values = axes.values ? header.axes[*axes.values].size : 1;
  if (n_components > 0)
    check_components(unsigned(std::min<std::size_t>(n_values, 1u << 20)), n_components, path);
  std::array<std::size_t, 3> size;
  for (unsigned d = 0; d < 3; ++d)
    size[d] = header.axes[axes.first + d].size;
  check_size(size, path);
  const Data data = load(path);
  Volume volume;
  volume.grid = regular_grid(size, place ? steps_of(*place) : by_spacings(*data, axes, file));
  const std::size_t n_voxels = volume.grid.n_voxels();
  if (nrrdElementNumber(data.get()) != n_voxels * n_values)
    refuse_nrrd_header(file, "has sizes that its library reads otherwise");
  StoredValues stored;
  stored.type = type_of(*data, file);
  stored.append(static_cast<const unsigned char*>(data->data), n_voxels * n_values, volume.values);
  if (n_values == 1 || axes.first == 1)
    return volume;
  std::vector<float> together(volume.values.size()); // all values of one voxel
  for (std::size_t v = 0; v < n_voxels; ++v)
    for (std::size_t c = 0; c < n_values; ++c)
      together[v * n_values + c] = volume.values[c * n_voxels + v];
  volume.values = std::move(together);
  return volume;
}

} // namespace prosup::image
