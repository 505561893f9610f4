#ifndef PROSUP_SRC_IMAGE_VOLUME_H
#define PROSUP_SRC_IMAGE_VOLUME_H

#include <filesystem>
#include <vector>

#include "prosup/core/remarks.h"
#include "prosup/image/image_io.h"

namespace prosup::image {

/// What a file holds: a grid and the values at its voxels, one voxel after the other.
struct Volume {
  VoxelGrid grid;
  std::vector<float> values;
  double step = 0.; ///< between values that are stored as neighbouring integers; 0: none
};

// All throw Error if the file cannot be used, or std::domain_error, which continues "its ", if its
// voxels lie on no regular grid. `n_components` are the values that a voxel has to have.

Volume read_nifti(const std::filesystem::path& file, unsigned n_components,
                  NiftiTransform transform, Remarks& remarks);
Volume read_meta_image(const std::filesystem::path& file, unsigned n_components, Remarks& remarks);
/// With 0 components: as many as the file has.
Volume read_nrrd(const std::filesystem::path& file, unsigned n_components, Remarks& remarks);

// The files with the voxels that belong to a header; maybe the same file.

std::vector<std::filesystem::path> nifti_voxel_files(const std::filesystem::path& header);
std::vector<std::filesystem::path> meta_voxel_files(const std::filesystem::path& header);

/// @throws Error if a voxel has another number of values.
void check_components(unsigned found, unsigned needed, const std::filesystem::path& file);

} // namespace prosup::image

#endif
