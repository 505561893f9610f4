#ifndef PROSUP_SRC_PIPELINE_RESULT_FIELDS_H
#define PROSUP_SRC_PIPELINE_RESULT_FIELDS_H

#include <filesystem>
#include <string>

#include "prosup/image/rigid_transform.h"
#include "prosup/image/voxel_image.h"

namespace prosup::pipeline {

/// The displacement fields of a finished registration.
class ResultFields {
public:
  /// @throws Error if `result` is no result folder of `register`, or of a version that did not keep
  /// how the chests were aligned.
  explicit ResultFields(std::filesystem::path result);

  /// The field on the grid of the state `from` that leads to the state `to`. Of those from the
  /// loaded states to the unloaded one, which are not among the results, it is computed.
  /// @throws Error if a file is missing or damaged.
  image::VectorImage field(const std::string& from, const std::string& to) const;

  /// The same on another grid of the space of `from`: in the mesh as `prosup map` has it, elsewhere
  /// interpolated, and beyond the grid of `from` as the chest moves.
  image::VectorImage field_on(const image::VoxelGrid& grid, const std::string& from,
                              const std::string& to) const;

  /// The motion of the chest between two states.
  image::RigidTransform chest_motion(const std::string& from, const std::string& to) const;

private:
  image::VectorImage read(const std::string& from, const std::string& to) const;
  image::VectorImage to_unloaded(const std::string& from) const;

  const std::filesystem::path result_;
  image::RigidTransform supine_to_prone_;
};

} // namespace prosup::pipeline

#endif
