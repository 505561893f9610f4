#ifndef PROSUP_SRC_IMAGE_NRRD_HEADER_H
#define PROSUP_SRC_IMAGE_NRRD_HEADER_H

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "prosup/core/remarks.h"

namespace prosup::image {

/// The fields of an NRRD header that say where its voxels are and how many bytes they need.
/// Format: https://teem.sourceforge.net/nrrd/format.html
struct NrrdHeader {
  /// One axis of the array, first the one that runs fastest.
  struct Axis {
    std::size_t size = 0;
    std::optional<std::array<double, 3>> direction; ///< to the next voxel; none: `none`
  };

  std::map<std::string, std::string> fields; ///< "name: value", names in lower case
  std::map<std::string, std::string> keys;   ///< "key:=value"
  std::vector<std::string> data_files;       ///< lines behind "data file: LIST"
  std::size_t length = 0;                    ///< of the header, with the blank line, bytes
  bool ends = false;                         ///< whether a blank line ends it

  std::vector<Axis> axes;
  std::array<double, 3> origin{0., 0., 0.};

  /// The value of a field; empty if there is none.
  std::string field(const std::string& name) const;
};

/// Reads the text of a header; what follows its blank line is not looked at.
/// @throws Error that names `file` if this is no header of an image in space: no NRRD, a field is
/// missing or twice there, or numbers are none.
NrrdHeader parse_nrrd_header(const std::string& text, const std::string& file);

/// @throws Error that says `what` is wrong with the header of `file`.
[[noreturn]] void refuse_nrrd_header(const std::string& file, const std::string& what);

/// What the voxels need in memory, bytes; the largest number if they need more.
std::uintmax_t n_data_bytes(const NrrdHeader& header, const std::string& file);

/// Where the voxels are, in LPS and mm.
struct NrrdPlace {
  std::array<double, 3> origin{0., 0., 0.};
  std::array<std::array<double, 3>, 3> step{}; ///< from a voxel to the next along each axis, mm
};

/// The place that `space`, `space units`, `space directions` and `space origin` give, or nothing if
/// the header has spacings only. What is assumed or converted goes to `remarks`.
/// @throws Error that names `file` if the voxel size or the unit is not known.
std::optional<NrrdPlace> nrrd_place(const NrrdHeader& header, const std::string& file,
                                    Remarks& remarks);

} // namespace prosup::image

#endif
