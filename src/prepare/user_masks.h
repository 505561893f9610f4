#ifndef PROSUP_SRC_PREPARE_USER_MASKS_H
#define PROSUP_SRC_PREPARE_USER_MASKS_H

#include "prosup/prepare/preparation.h"
#include "prosup/prepare/tissues.h"

namespace prosup::prepare {

/// The masks on the voxels of a scan. @throws Error if one of them marks no voxel of it.
UserMasks on_grid(const UserMasks& masks, const image::VoxelGrid& scan);

/// The front of a mask of the chest, continued where it has gaps.
ChestWall wall_of_mask(const image::LabelImage& chest, const TrunkAxis& axis, const FatSign& fat);

/// What lies further behind the front of a mask of the chest is chest even if the mask leaves it
/// out, mm; nearer than that its own voxels tell.
inline constexpr double depth_behind_mask = 3.;

/// The tissues with the gland of a mask, as far as it is in front of the wall.
Tissues tissues_of_mask(const TissueImage& image, const image::LabelImage& parts,
                        const image::LabelImage& gland);

} // namespace prosup::prepare

#endif
