#ifndef PROSUP_SRC_PREPARE_BODY_PARTS_H
#define PROSUP_SRC_PREPARE_BODY_PARTS_H

#include "prosup/prepare/preparation.h"

namespace prosup::prepare {

inline constexpr std::uint8_t in_front_of_wall = 1, behind_wall = 2, not_shown = 3;

/// Splits the body at the chest wall, or as the masks tell; they are on the grid of the body.
image::LabelImage front_and_chest(const image::LabelImage& body, const TrunkSurface& chest,
                                  const UserMasks& masks);

} // namespace prosup::prepare

#endif
