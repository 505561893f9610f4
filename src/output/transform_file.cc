#include "prosup/output/transform_file.h"

#include <sys/utsname.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hdf5_errors.h"
#include "prosup/core/error.h"
#include "prosup/core/text.h"
#include "prosup/core/text_file.h"

// The serial C interface instead of Hdf5Writer: deal.II's has no text data sets and no compression,
// and what other programs read bears no checksum. ITK's own would bring a second HDF5 into the
// process.
namespace prosup::output {

namespace {

constexpr hsize_t chunk = 1 << 18; // numbers that are compressed at a time
constexpr unsigned compression_level = 4;
constexpr std::size_t growth = 1 << 20; // of a file in memory, bytes

/// Something of HDF5 that is closed in the end.
class Handle {
public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0)
      close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

private:
  const hid_t id_;
  herr_t (*const close_)(hid_t);
};

/// A data set of one dimension; the same values make the same bytes at any time.
void write_data(hid_t file, const char* name, hid_t type, hsize_t n, const void* values,
                bool compressed = false) {
  const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose),
      properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties, false);
  if (compressed) {
    const hsize_t length = std::min(n, chunk);
    H5Pset_chunk(properties, 1, &length);
    H5Pset_shuffle(properties);
    H5Pset_deflate(properties, compression_level);
  }
  const Handle data(H5Dcreate2(file, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
                    H5Dclose);
  H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
}

void write_text(hid_t file, const char* name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, H5T_VARIABLE);
  const char* const words = text.c_str();
  write_data(file, name, type, 1, &words);
}

/// Size, origin, spacing and direction, row by row, as ITK's DisplacementFieldTransform has them.
std::vector<double> fixed_parameters(const image::VoxelGrid& grid) {
  std::vector<double> all(grid.size.begin(), grid.size.end());
  for (unsigned d = 0; d < 3; ++d)
    all.push_back(grid.origin[d]);
  for (unsigned d = 0; d < 3; ++d)
    all.push_back(grid.spacing[d]);
  for (unsigned d = 0; d < 3; ++d)
    for (unsigned e = 0; e < 3; ++e)
      all.push_back(grid.direction[d][e]);
  return all;
}

void write_group(hid_t file, const char* name) {
  const Handle group(H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
}

/// What itk::HDF5TransformIO writes; it does not look at the versions.
void write_layout(hid_t file, const image::VectorImage& field) {
  utsname system{};
  uname(&system);
  write_text(file, "ITKVersion", "5.2.1"); // which has this layout
  write_text(file, "HDFVersion", H5_VERS_INFO);
  write_text(file, "OSName", system.sysname);
  write_text(file, "OSVersion", system.release);
  write_group(file, "TransformGroup");
  write_group(file, "TransformGroup/0");
  write_text(file, "TransformGroup/0/TransformType", "DisplacementFieldTransform_float_3_3");
  const std::vector<double> fixed = fixed_parameters(field.grid);
  write_data(file, "TransformGroup/0/TransformFixedParameters", H5T_NATIVE_DOUBLE, fixed.size(),
             fixed.data());
  write_data(file, "TransformGroup/0/TransformParameters", H5T_NATIVE_FLOAT,
             3 * field.values.size(), field.values.data(), true);
}

/// The contents of the file, made in memory: it is then written as any other.
std::string bytes_of(const image::VectorImage& field) {
  Hdf5Errors errors;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access, growth, false);
  const Handle file(H5Fcreate("transform", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  write_layout(file, field);
  H5Fflush(file, H5F_SCOPE_GLOBAL);
  std::string bytes(
      static_cast<std::size_t>(std::max<ssize_t>(0, H5Fget_file_image(file, nullptr, 0))), '\0');
  H5Fget_file_image(file, bytes.data(), bytes.size());
  if (!errors.first().empty())
    throw Error("The transform of ITK cannot be made (HDF5: " + errors.first() + ").");
  return bytes;
}

} // namespace

bool is_transform(const std::filesystem::path& file) {
  return ends_with(lower_case(file.filename().string()), ".h5");
}

void write_transform(const image::VectorImage& field, const std::filesystem::path& file) {
  for (const auto& u : field.values)
    if (!std::isfinite(u[0] + u[1] + u[2]))
      throw Error("A displacement for '" + file.string() +
                  "' is not a finite number; the transform was not written.");
  write_text_file(bytes_of(field), file);
}

} // namespace prosup::output
