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
  /// if there is none within reach; x then is moved to the faces of the box only.
  bool apply(Point<3>& x, unsigned patches) const;

  void set_level(double level) { level_ = level; }

private:
  const LevelSet& phi_;
  double reach_;
  double level_ = 0.;
};

} // namespace prosup::mesh

#endif
