#ifndef PROSUP_SRC_FDM_LOADED_MAPS_H
#define PROSUP_SRC_FDM_LOADED_MAPS_H

#include <array>
#include <cstdint>
#include <vector>

#include "prosup/fdm/fdm_parameters.h"
#include "prosup/fdm/material.h"
#include "prosup/fdm/vector_field.h"

namespace prosup::fdm {

/// M0 of the paper's eq. 8: material and forces of the body as it was imaged, stored on a
/// grid of its own, from which the simulation resamples them.
class LoadedMaps {
public:
  /// Averages the labels on a grid of `spacing` mm around the image. What is neither
  /// tissue nor chest is background. If `chest_is_soft`, the chest is background too;
  /// otherwise the material next to the chest continues into it. Beyond the image the
  /// values at its border continue.
  LoadedMaps(const image::LabelImage& labels, const std::vector<unsigned>& tissue_labels,
             unsigned chest_label, double spacing, bool chest_is_soft);

  /// Sets lambda and mu of the tissues, and of a background with `stiffness` times those
  /// of the softest tissue.
  void set_material(const Material& material, double stiffness);

  /// Values at a point of the loaded configuration.
  struct Values {
    float mu = 0.f, lambda = 0.f;           ///< Pa
    float tissue = 0.f;                     ///< part of the volume, which has weight
    float chest = 0.f;                      ///< part of the volume
    std::array<float, 3> force{0., 0., 0.}; ///< force density, g/(mm^2 s^2)
    float unused = 0.f;                     ///< fills up to eight floats, two SIMD vectors
  };
  Values values(const Point<3>& position) const;
  const image::VoxelGrid& grid() const { return grid_; }

  /// The force density at each point of the grid.
  void set_force(std::size_t node, const Tensor<1, 3>& force);

  /// Which faces of the image, low and high along each axis, tissue touches.
  using Faces = std::array<std::array<bool, 2>, 3>;
  const Faces& touched_faces() const { return touched_; }
  /// Corners of the box of the image along LPS.
  const Point<3>& low() const { return low_; }
  const Point<3>& high() const { return high_; }

private:
  using Index = std::array<std::size_t, 3>;

  void average(const image::LabelImage& labels, unsigned chest_label);
  void note_touched_faces(const image::VoxelGrid& voxels, const Index& voxel);
  void spread(const image::VoxelGrid& voxels, const Index& voxel, const Index& n_cuts,
              unsigned part);
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
