#ifndef PROSUP_SRC_PREPARE_COARSE_WALL_H
#define PROSUP_SRC_PREPARE_COARSE_WALL_H

#include "prosup/prepare/chest_wall.h"
#include "wall_costs.h"

namespace prosup::prepare {

/// Sweeps of minimal_surface() that are enough.
inline constexpr unsigned n_wall_sweeps = 4;

/// Radii of the levels that were chosen, mm.
ColumnMap radii(const Profiles& profiles, const std::vector<std::size_t>& levels);

/// The coarse surface of find_chest_wall(), and what was found with it.
class CoarseWall {
public:
  /// @throws Error if the body is nowhere thick enough for a chest.
  CoarseWall(const ProfileSource& source, const TrunkAxis& axis, bool fat_is_bright);

  /// Makes the surface that of a chest. It is searched again with a cost of 0.05 for each mm that
  /// it lies more than 16 mm behind a smooth chest, within 45 degrees of the front: behind the
  /// upper sternum, the edges of vessels and lung are as clear as that of the chest. Hills that are
  /// closed all around, 11 mm or more above their surroundings, are gland of the intensity of
  /// muscle on the chest, and are cut off where the surroundings are continued. Tells what was
  /// changed, and what still departs from a smooth chest.
  void correct_shape();

  const TrunkGrid& grid() const { return profiles_.grid; }
  const FrontTissue& tissue() const { return tissue_; }
  const ColumnMap& radius() const { return radius_; }
  double mean_cost() const; ///< of the columns with skin
  /// 1 in columns where skin lies on the chest, without fat between them; after correct_shape().
  const ColumnMap& bare() const { return bare_; }
  /// 1 in columns where a hill was taken away.
  const ColumnMap& hill() const { return hill_; }
  const Departure& bridged() const { return bridged_; }
  const Departure& departure() const { return departure_; }

private:
  float cost(std::size_t column) const {
    return costs_.values[column * costs_.n_levels + levels_[column]];
  }
  double angle(std::size_t column) const { return grid().angle(column % grid().n_columns); }
  void find_surface(const SurfaceCosts& costs);
  /// Of those in front, the columns in which something speaks for the wall.
  std::vector<char> told_columns(const std::vector<char>& in_front) const;
  /// The costs, and more for what lies far behind the smooth chest.
  SurfaceCosts costs_above_pits(const ColumnMap& smooth) const;
  ColumnMap above(const ColumnMap& smooth) const;
  Departure departure_of(const std::vector<char>& columns, const ColumnMap& departure) const;

  const bool fat_is_bright_;
  Profiles profiles_;
  FrontTissue tissue_;
  SurfaceCosts costs_{0, 0, 0};
  std::vector<std::size_t> levels_;
  ColumnMap radius_, bare_, hill_;
  Departure bridged_, departure_;
};

} // namespace prosup::prepare

#endif
