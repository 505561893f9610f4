#include "mesh_figures.h"

#include <algorithm>

#include "prosup/evaluation/point_mapper.h"
#include "prosup/mesh/quality.h"

namespace prosup::pipeline {

using dealii::Point;
using dealii::Tensor;
using evaluation::PointMapper;

namespace {

/// The mean motion of the nodes of the prone mesh to supine, as seen from the chest.
registration::Motion motion_of(const std::vector<Point<3>>& points, const PointMapper& prone,
                               const PointMapper& supine, const image::RigidTransform& alignment,
                               const Tensor<1, 3>& fall) {
  registration::Motion motion;
  for (const Point<3>& point : points) {
    const Tensor<1, 3> way = alignment(supine.to_loaded(prone.to_unloaded(point))) - point;
    motion.mean += way.norm() / static_cast<double>(points.size());
    motion.along_gravity += way * fall / static_cast<double>(points.size());
  }
  return motion;
}

} // namespace

evaluation::ErrorStatistics measure_meshes(const registration::RegistrationResult& found,
                                           const PerPosition<Tensor<1, 3>>& gravity,
                                           const image::RigidTransform& alignment,
                                           registration::Quality& quality) {
  for (const Position position : both_positions) {
    const mesh::UnloadedMesh& mesh = found.meshes[position];
    quality.jacobian[position] = mesh::jacobian_range(mesh);
    mesh::TetMesh unloaded = mesh.mesh;
    unloaded.points = mesh.unloaded;
    quality.unloaded_quality[position] = mesh::measure_quality(unloaded).min_quality;
  }
  const PointMapper prone(found.meshes.prone), supine(found.meshes.supine);
  const std::vector<Point<3>>& nodes = found.meshes.prone.mesh.points;
  const Tensor<1, 3> change = alignment.rotation * gravity.supine / gravity.supine.norm() -
                              gravity.prone / gravity.prone.norm();
  quality.motion =
      motion_of(nodes, prone, supine, alignment, change / std::max(change.norm(), 1e-9));
  const evaluation::ErrorStatistics consistency =
      evaluation::inverse_consistency(nodes, prone, supine);
  quality.inverse_p95 = consistency.p95;
  return consistency;
}

} // namespace prosup::pipeline
