#ifndef PROSUP_TESTS_UNIT_IMAGE_NRRD_TEXT_H
#define PROSUP_TESTS_UNIT_IMAGE_NRRD_TEXT_H

#include <string>

namespace prosup::tests {

/// The fields of a 3 x 2 x 2 image of 2 mm voxels, but for those that say where its data are.
inline std::string nrrd_fields(const std::string& space = "left-posterior-superior") {
  return "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 3 2 2\nspace: " + space +
         "\nspace directions: (2,0,0) (0,2,0) (0,0,2)\nspace origin: (10,20,30)\n";
}

/// Values 0 to n - 1, one byte each.
inline std::string counting_bytes(std::size_t n) {
  std::string bytes;
  for (std::size_t i = 0; i < n; ++i)
    bytes += static_cast<char>(i);
  return bytes;
}

} // namespace prosup::tests

#endif
