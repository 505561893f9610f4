#ifndef PROSUP_TESTS_UNIT_IMAGE_NIFTI_BYTES_H
#define PROSUP_TESTS_UNIT_IMAGE_NIFTI_BYTES_H

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace prosup::tests {

/// Where the fields of a NIfTI-1 header are, bytes (https://nifti.nimh.nih.gov/nifti-1).
struct nifti_field {
  static constexpr std::size_t dim = 40, intent_code = 68, datatype = 70, bitpix = 72, pixdim = 76,
                               vox_offset = 108, scl_slope = 112, scl_inter = 116, xyzt_units = 123,
                               qform_code = 252, sform_code = 254, quatern = 256, qoffset = 268,
                               srow = 280, magic = 344;
};

/// A NIfTI-1 file written byte by byte: 4 x 3 x 2 voxels of 1.5 x 2 x 3 mm along right, anterior
/// and superior, the first at RAS (10, 20, 30), by qform and sform, with the int16 values 0 to 23.
class NiftiBytes {
public:
  explicit NiftiBytes(bool swapped = false) : swapped_(swapped), bytes_(352, '\0') {
    using f = nifti_field;
    put<std::int32_t>(0, {348});
    put<std::int16_t>(f::dim, {3, 4, 3, 2, 1, 1, 1, 1});
    put<float>(f::pixdim, {1.f, 1.5f, 2.f, 3.f});
    put<float>(f::vox_offset, {352.f});
    put<float>(f::scl_slope, {1.f, 0.f});
    bytes_[f::xyzt_units] = 2;
    put<std::int16_t>(f::qform_code, {1, 1});
    put<float>(f::qoffset, {10.f, 20.f, 30.f});
    put<float>(f::srow, {1.5f, 0.f, 0.f, 10.f, 0.f, 2.f, 0.f, 20.f, 0.f, 0.f, 3.f, 30.f});
    bytes_.replace(f::magic, 3, "n+1");
    std::vector<std::int16_t> values(24);
    for (std::size_t v = 0; v < 24; ++v)
      values[v] = static_cast<std::int16_t>(v);
    voxels(4, values);
  }

  /// Writes numbers at a place of the header.
  template <typename Number>
  NiftiBytes& put(std::size_t place, const std::vector<Number>& numbers) {
    for (const Number number : numbers) {
      bytes_.replace(place, sizeof(Number), ordered(number));
      place += sizeof(Number);
    }
    return *this;
  }

  /// The numbers of the voxels, and their type.
  template <typename Number>
  NiftiBytes& voxels(int datatype, const std::vector<Number>& numbers) {
    put<std::int16_t>(nifti_field::datatype,
                      {std::int16_t(datatype), std::int16_t(8 * sizeof(Number))});
    voxels_.clear();
    for (const Number number : numbers)
      voxels_ += ordered(number);
    return *this;
  }

  NiftiBytes& behind_header(const std::string& more) {
    bytes_ += more;
    return *this;
  }
  NiftiBytes& behind_voxels(const std::string& more) {
    voxels_ += more;
    return *this;
  }

  std::string header() const { return bytes_.substr(0, 348); }
  std::string voxels() const { return voxels_; }
  std::string all() const { return bytes_ + voxels_; }

private:
  template <typename Number>
  std::string ordered(Number number) const {
    std::string bytes(sizeof(Number), '\0');
    std::memcpy(bytes.data(), &number, sizeof(Number));
    if (swapped_)
      std::reverse(bytes.begin(), bytes.end());
    return bytes;
  }

  bool swapped_;
  std::string bytes_, voxels_;
};

inline void write_bytes(const std::string& bytes, const std::filesystem::path& file) {
  std::ofstream(file, std::ios::binary) << bytes;
}

inline void write_gzip(const std::string& bytes, const std::filesystem::path& file) {
  gzFile out = gzopen(file.c_str(), "wb");
  gzwrite(out, bytes.data(), static_cast<unsigned>(bytes.size()));
  gzclose(out);
}

} // namespace prosup::tests

#endif
