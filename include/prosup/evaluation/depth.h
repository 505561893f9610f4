#ifndef PROSUP_EVALUATION_DEPTH_H
#define PROSUP_EVALUATION_DEPTH_H

#include <deal.II/base/point.h>

#include <memory>
#include <optional>
#include <vector>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::evaluation {

/// How far a point is from the boundary of a breast, mm; nothing for a part that its mesh does not
/// tell, such as all parts of the meshes of finite differences.
struct Depth {
  std::optional<double> skin, chest_wall;
};

/// Measures depths in one configuration of a breast.
class DepthGauge {
public:
  /// `nodes` are the positions of the nodes of `mesh` in that configuration.
  DepthGauge(const mesh::TetMesh& mesh, const std::vector<dealii::Point<3>>& nodes);
  ~DepthGauge();
  DepthGauge(DepthGauge&&) noexcept;
  DepthGauge& operator=(DepthGauge&&) noexcept;

  /// Distances to the nearest points of the faces of each part.
  Depth operator()(const dealii::Point<3>& point) const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The node of the skin that is furthest from the chest wall in the loaded configuration, LPS, mm:
/// where the nipple is, about. Nothing if the mesh does not tell both parts.
std::optional<dealii::Point<3>> tip_of(const mesh::TetMesh& mesh);

} // namespace prosup::evaluation

#endif
