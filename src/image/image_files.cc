#include "prosup/image/image_files.h"

#include <algorithm>

#include "file_formats.h"
#include "meta_files.h"
#include "nrrd_data.h"
#include "nrrd_file.h"
#include "volume.h"

namespace prosup::image {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> voxel_files_of(const fs::path& header) {
  switch (format_of(header)) {
  case FileFormat::nifti:
    return nifti_voxel_files(header);
  case FileFormat::nrrd:
    return nrrd_data_files(read_nrrd_header(header), header);
  default:
    return meta_voxel_files(header);
  }
}

} // namespace

std::vector<fs::path> files_of_image(const fs::path& file) {
  std::vector<fs::path> files{file};
  try {
    const fs::path header = file_with_header(file);
    std::vector<fs::path> others = voxel_files_of(header);
    others.push_back(header);
    for (const fs::path& other : others)
      if (std::find(files.begin(), files.end(), other) == files.end())
        files.push_back(other);
  } catch (const std::exception&) { // who reads it tells what is wrong
  }
  return files;
}

} // namespace prosup::image
