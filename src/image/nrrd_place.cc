#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "nrrd_header.h"
#include "prosup/core/error.h"
#include "prosup/core/text.h"

namespace prosup::image {

std::uintmax_t n_data_bytes(const NrrdHeader& header, const std::string& file) {
  // The first that is part of a name such as "unsigned short int".
  constexpr std::array<std::pair<const char*, unsigned>, 10> sizes{{{"char", 1},
                                                                    {"int8", 1},
                                                                    {"short", 2},
                                                                    {"int16", 2},
                                                                    {"int64", 8},
                                                                    {"long", 8},
                                                                    {"double", 8},
                                                                    {"float", 4},
                                                                    {"int", 4},
                                                                    {"block", 1}}};
  const std::string type = lower_case(header.field("type"));
  const auto found = std::find_if(sizes.begin(), sizes.end(), [&](const auto& size) {
    return type.find(size.first) != std::string::npos;
  });
  if (found == sizes.end())
    refuse_nrrd_header(file, "has the type '" + type + "', which is no type of voxels");
  std::uintmax_t bytes = found->second;
  for (const NrrdHeader::Axis& axis : header.axes) {
    if (bytes > std::numeric_limits<std::uintmax_t>::max() / axis.size)
      return std::numeric_limits<std::uintmax_t>::max();
    bytes *= axis.size;
  }
  return bytes;
}

namespace {

/// Length of the unit of space in mm.
double unit_in_mm(const NrrdHeader& header, const std::string& file) {
  static const std::map<std::string, double> known{
      {"", 1.},     {"mm", 1.},         {"cm", 10.},         {"m", 1e3},
      {"um", 1e-3}, {"micron", 1e-3},   {"\xC2\xB5m", 1e-3}, {"\xCE\xBCm", 1e-3},
      {"nm", 1e-6}, {"millimeter", 1.}, {"millimetre", 1.}};
  const std::string text = header.field("space units");
  std::vector<std::string> units;
  for (std::size_t open = 0; (open = text.find('"', open)) != std::string::npos;) {
    const std::size_t close = std::min(text.find('"', open + 1), text.size());
    units.push_back(trimmed(text.substr(open + 1, close - open - 1)));
    open = std::min(close + 1, text.size());
  }
  if (units.empty() && text.empty())
    return 1.;
  if (units.empty())
    units.push_back(text);                                     // one word without quotes
  const auto n_space = std::min<std::size_t>(units.size(), 3); // a fourth is that of time
  const auto found = known.find(units[0]);
  if (found == known.end() ||
      std::count(units.begin(), units.begin() + long(n_space), units[0]) != long(n_space))
    refuse_nrrd_header(file, "has the 'space units' " + text.substr(0, 40) +
                                 ", which are not one known unit of length");
  return found->second;
}

/// Whether 'spacings' gives the size of three axes at least.
bool has_spacings(const NrrdHeader& header) {
  unsigned n_known = 0;
  std::istringstream spacings(header.field("spacings"));
  for (std::string text; spacings >> text;) {
    double value = 0.;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    n_known += error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
  }
  return n_known >= 3;
}

/// Factors that take the axes of a space to LPS.
std::array<double, 3> to_lps(const NrrdHeader& header, const std::string& file, Remarks& remarks) {
  const std::string written = header.field("space").substr(0, 40);
  std::string space = lower_case(written);
  if (const std::size_t time = space.find("-time"); time != std::string::npos)
    space.erase(time);
  if (space == "left-posterior-superior" || space == "lps")
    return {1., 1., 1.};
  if (space == "right-anterior-superior" || space == "ras")
    return {-1., -1., 1.};
  if (space == "left-anterior-superior" || space == "las")
    return {1., -1., 1.};
  remarks.add(
      "The NRRD header of '" + file + "' does not say how its space lies in the patient (" +
      (space.empty() ? "no field 'space'" : "'space: " + written + "'") +
      "); its coordinates were taken as LPS, so check that the breast lies where it should.");
  return {1., 1., 1.};
}

} // namespace

std::optional<NrrdPlace> nrrd_place(const NrrdHeader& header, const std::string& file,
                                    Remarks& remarks) {
  NrrdPlace place;
  unsigned n_directions = 0;
  const std::array<double, 3> sign = to_lps(header, file, remarks);
  const double unit = unit_in_mm(header, file);
  for (const NrrdHeader::Axis& axis : header.axes) {
    if (!axis.direction || n_directions++ >= 3)
      continue;
    std::array<double, 3>& step = place.step[n_directions - 1];
    for (unsigned d = 0; d < 3; ++d)
      step[d] = unit * sign[d] * (*axis.direction)[d];
    if (!(std::hypot(step[0], step[1], step[2]) > 0.))
      refuse_nrrd_header(file, "has a space direction of length 0");
  }
  if (n_directions == 0) {
    if (!has_spacings(header))
      refuse_nrrd_header(
          file, "has neither 'space directions' nor 'spacings', so the size of its voxels is not "
                "known");
    return {};
  }
  if (n_directions != 3)
    refuse_nrrd_header(file, "has " + std::to_string(n_directions) +
                                 " space directions where an image has 3");
  if (header.field("space origin").empty())
    remarks.add("The NRRD header of '" + file +
                "' has no 'space origin'; the first voxel was put at LPS (0, 0, 0), so check that "
                "the breast lies where it should.");
  for (unsigned d = 0; d < 3; ++d)
    place.origin[d] = unit * sign[d] * header.origin[d];
  if (unit != 1.)
    remarks.add("The NRRD header of '" + file + "' has 'space units' " +
                header.field("space units") + "; its coordinates were converted to mm.");
  return place;
}

} // namespace prosup::image
