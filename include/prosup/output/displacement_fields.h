#ifndef PROSUP_OUTPUT_DISPLACEMENT_FIELDS_H
#define PROSUP_OUTPUT_DISPLACEMENT_FIELDS_H

#include <functional>

#include "prosup/evaluation/point_mapper.h"
#include "prosup/image/rigid_transform.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::output {

// Displacement fields in ITK's convention: the value at a grid point is the displacement of that
// point, in mm (LPS). In the mesh it is that of the linear elements. Outside, the chest moves
// rigidly. All else moves with the closest point of the mesh within a voxel's diagonal of it, and
// turns from there into the rigid motion of the chest over twice the distance by which that point
// moves relative to the chest, at least 10 mm, so that space beside the mesh does not fold. Away
// from the chest the fields are continuous. Outside of the mesh they are rounded to 1/1024 mm.

/// The motion of what no mesh describes.
struct RigidChest {
  image::RigidTransform motion{}; ///< from the space of a field's grid to that which it leads to
  /// Whether a point of the grid's space is in the chest; nowhere, if empty.
  std::function<bool(const dealii::Point<3>&)> contains{};
};

/// Whether the voxel of `labels` at a point of `to_labels(its space)` has this label; outside of
/// the image there is none. Keeps a reference to the labels.
std::function<bool(const dealii::Point<3>&)>
voxels_with(const image::LabelImage& labels, unsigned label,
            const image::RigidTransform& to_labels = {});

/// A displacement field and where it is that of the breast.
struct StateField {
  image::VectorImage displacement; ///< mm, LPS
  /// 1 where it is that of the tissue: in the mesh, and where the tissue goes through another mesh,
  /// in that or at most evaluation::far_outside from it; 0 elsewhere.
  image::LabelImage valid;
};

/// u = x - X on a grid of the unloaded configuration.
/// @throws Error if no voxel centre is in the mesh.
StateField unloaded_to_loaded(const image::VoxelGrid& grid, const mesh::UnloadedMesh& mesh,
                              const evaluation::PointMapper& mapper, const RigidChest& chest = {});

/// X - x on a grid of the loaded configuration. @throws Error as above.
StateField loaded_to_unloaded(const image::VoxelGrid& grid, const mesh::UnloadedMesh& mesh,
                              const evaluation::PointMapper& mapper, const RigidChest& chest = {});

/// Displacement from one loaded configuration to the other, through the unloaded one:
/// x_to(X(x_from)) - x_from on a grid of the loaded configuration of `from`.
/// @throws Error if no voxel centre is in the mesh.
StateField loaded_to_loaded(const image::VoxelGrid& grid, const mesh::UnloadedMesh& from,
                            const evaluation::PointMapper& from_mapper,
                            const evaluation::PointMapper& to_mapper, const RigidChest& chest = {});

} // namespace prosup::output

#endif
