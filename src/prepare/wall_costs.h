#ifndef PROSUP_SRC_PREPARE_WALL_COSTS_H
#define PROSUP_SRC_PREPARE_WALL_COSTS_H

#include "minimal_surface.h"
#include "profiles.h"

namespace prosup::prepare {

/// What the profiles say of the tissue in front of the chest.
struct FrontTissue {
  ColumnMap skin; ///< radius where the innermost run of body ends, mm; no number where
                  ///< there is no body, or where the border of the image cuts it off
  ColumnMap fat;  ///< scaled intensity of the fat below the skin
};

FrontTissue find_front_tissue(const Profiles& profiles, bool fat_is_bright);

/// Where bright fat is missing below the skin, what was taken for it is muscle: fat that is much
/// darker than elsewhere is set to the darkest that it can be. @returns whether there was any.
bool exclude_muscle(FrontTissue& tissue, bool fat_is_bright);

/// How the costs of a wall between the samples i - 1 and i are made; lengths in mm.
struct WallWindows {
  double front = 7.;      ///< in front, that has to be fat
  double behind = 7.;     ///< behind, that has to differ from it
  double far_front = 18.; ///< in front of `front`, that should be fat
  double fat_weight = 1., far_weight = 0.5;
  double largest_contrast = 0.6;
};

/// Costs with a level for each sample. `skin` and `fat` are those of the columns of `profiles`.
SurfaceCosts wall_costs(const Profiles& profiles, const FrontTissue& tissue, bool fat_is_bright,
                        const WallWindows& windows);

/// Cost of a level at which there can be no wall.
inline constexpr float no_wall = 1.5f;

} // namespace prosup::prepare

#endif
