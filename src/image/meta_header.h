#ifndef PROSUP_SRC_IMAGE_META_HEADER_H
#define PROSUP_SRC_IMAGE_META_HEADER_H

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "prosup/core/remarks.h"
#include "prosup/image/voxel_image.h"
#include "stored_values.h"

namespace prosup::image {

/// What prosup needs of a MetaImage header.
/// Format: https://itk.org/Wiki/MetaIO/Documentation, and the code of MetaIO where that is silent.
struct MetaHeader {
  std::array<std::size_t, 3> size{};
  Point<3> origin;
  Tensor<1, 3> spacing;
  Tensor<2, 3> direction; ///< as in the file; columns are axes

  StoredValues values;
  bool is_binary = true; ///< or else text
  bool is_packed = false;
  std::optional<std::uintmax_t> packed_size;
  std::int64_t skipped = 0; ///< bytes before the voxels; -1: all that are too many

  std::string data_file;  ///< the value of ElementDataFile
  std::size_t length = 0; ///< bytes of the header, with its last line end
  bool is_local() const;  ///< whether the voxels follow the header
};

/// Whether a file that begins so is a MetaImage.
bool is_meta_image(const std::string& text);

/// Reads the text of a header. What is doubtful goes to `remarks`.
/// @throws Error that names `file` if an entry is missing or makes no sense, or if it is not the
/// header of one volume.
MetaHeader parse_meta_header(const std::string& text, const std::string& file, Remarks& remarks);

} // namespace prosup::image

#endif
