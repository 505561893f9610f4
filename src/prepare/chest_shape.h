#ifndef PROSUP_SRC_PREPARE_CHEST_SHAPE_H
#define PROSUP_SRC_PREPARE_CHEST_SHAPE_H

#include "map_filters.h"
#include "prosup/prepare/trunk.h"

namespace prosup::prepare {

/// The smooth chest that a wall follows on the whole: the sum of products of Legendre polynomials,
/// of degree 6 in the angle (57 degrees to both sides) and 3 in z, fitted to the radii where
/// `counts` is not 0; first with the weights of the mean distance, then with Tukey's of 15 mm, so
/// that what stands out has no part in it. Outside of these angles it is that at their end.
ColumnMap smooth_chest(const TrunkGrid& grid, const ColumnMap& radius,
                       const std::vector<char>& counts);

/// By how much each column stands higher than the lowest point over which a path leads from it to a
/// column that does not count or to the border of the map: the height of a hill that is closed all
/// around, 0 on a slope.
ColumnMap hill_height(const ColumnMap& height, const std::vector<char>& counts);

/// The columns, as 1, of all hills that are `lowest` or more at their feet and `highest` or more at
/// their tops.
std::vector<char> hills(const ColumnMap& hill_height, double lowest, double highest);

/// Continues the values of the columns that are not `unknown` over those that are, as a membrane.
void bridge(ColumnMap& map, const std::vector<char>& unknown);

} // namespace prosup::prepare

#endif
