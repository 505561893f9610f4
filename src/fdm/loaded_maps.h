#ifndef PROSUP_SRC_FDM_LOADED_MAPS_H
#define PROSUP_SRC_FDM_LOADED_MAPS_H

#include <array>
#include <cstdint>
#include <vector>

#include "prosup/fdm/fdm_parameters.h"
#include "prosup/fdm/material.h"
#include "prosup/fdm/vector_field.h"

namespace prosup::fdm {

/// M0 of the paper's eq. 8: material and forces of the body as it was imaged, on
/// a grid of its own, from which everything is resampled.
class LoadedMaps {
public:
  /// Averages the labels to a grid of `spacing` mm that holds the image. What is
  /// neither tissue nor chest is background. If `chest_is_soft`, the chest is
  /// background too; else it does not count: tissue goes on into it. Beyond the
  /// image everything goes on as at its border.
  LoadedMaps(const image::LabelImage& labels, const std::vector<unsigned>& tissue_labels,
             unsigned chest_label, double spacing, bool chest_is_soft);

  /// lambda, mu of the tissues, and of a background whose mu is `stiffness` times
  /// that of the softest tissue.
  void set_material(const Material& material, double stiffness);

  /// What is at a place of the loaded configuration.
  struct Values {
    float mu = 0.f, lambda = 0.f;           ///< Pa
    float tissue = 0.f;                     ///< part of the volume, which has weight
    float chest = 0.f;                      ///< part of the volume
    std::array<float, 3> force{0., 0., 0.}; ///< force density, g/(mm^2 s^2)
    float unused = 0.f;                     ///< makes eight floats, two vectors
  };
  Values values(const Point<3>& position) const;
  const image::VoxelGrid& grid() const { return grid_; }

  /// The force density at each point of the grid.
  void set_force(std::size_t node, const Tensor<1, 3>& force);

  /// Faces of the image, low and high along each axis, that tissue touches.
  using Faces = std::array<std::array<bool, 2>, 3>;
  const Faces& touched_faces() const { return touched_; }
  /// Corners of the box of the image along LPS.
  const Point<3>& low() const { return low_; }
  const Point<3>& high() const { return high_; }

private:
  void average(const image::LabelImage& labels, unsigned chest_label);
  void normalise(bool chest_is_soft, double full_weight);
  void continue_into_chest(std::vector<bool> known);
  void continue_beyond();

  image::VoxelGrid grid_;
  Point<3> low_, high_;
  Faces touched_{};
  std::vector<unsigned> tissue_labels_;
  std::vector<std::vector<float>> parts_; ///< of each tissue, then of air, at each node
  std::vector<Values> values_;
};

} // namespace prosup::fdm

#endif
