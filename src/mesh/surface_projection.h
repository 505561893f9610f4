#ifndef PROSUP_MESH_SURFACE_PROJECTION_H
#define PROSUP_MESH_SURFACE_PROJECTION_H

#include "level_set.h"
#include "triangle_mesh.h"

namespace prosup::mesh {

/// Brings points to where they belong: the free surface phi = level, faces of
/// the box, or the curves and corners in which these meet.
class SurfaceProjection {
public:
  /// Points move by at most `reach` (mm) to the free surface.
  SurfaceProjection(const LevelSet& phi, double reach) : phi_(phi), reach_(reach) {}

  /// Set of the patch p of a TriangleMesh.
  static constexpr unsigned set_of(unsigned patch) { return 1u << patch; }

  /// Moves x to a point of all patches in the set `patches` near it. Returns false
  /// if there is none within reach and the box; x then is moved to the faces of the box only.
  bool apply(Point<3>& x, unsigned patches) const;

  /// Unit vector outwards at x on a patch: the normal of the plane, or the gradient of
  /// phi; zero where phi has none.
  dealii::Tensor<1, 3> outward(const Point<3>& x, unsigned patch) const;

  void set_level(double level) { level_ = level; }

private:
  bool inside_box(const Point<3>& x) const;

  const LevelSet& phi_;
  double reach_;
  double level_ = 0.;
};

} // namespace prosup::mesh

#endif
