#include "volume_mesher.h"

#include <gmsh.h>

#include <array>
#include <numeric>

#include "gmsh_session.h"

namespace prosup::mesh {

namespace {

/// gmsh's size inside over the mean length of the edges that come out.
constexpr double size_per_edge = 0.8;

/// Cells worse than this are improved, the worst first. Higher thresholds cost
/// many times as much and gain little; Relocate3D between the passes gains nothing.
constexpr std::array<double, 3> optimize_thresholds{0.45, 0.5, 0.6};

constexpr int gmsh_triangle = 2, gmsh_tetrahedron = 4;

void add_surface(const TriangleMesh& surface) {
  std::vector<std::size_t> node_tags(surface.points.size());
  std::iota(node_tags.begin(), node_tags.end(), 1);
  std::vector<double> coordinates;
  for (const Point<3>& x : surface.points)
    coordinates.insert(coordinates.end(), {x[0], x[1], x[2]});
  std::vector<std::size_t> corners;
  for (const auto& triangle : surface.triangles)
    for (const unsigned node : triangle)
      corners.push_back(node + 1);
  gmsh::model::addDiscreteEntity(2, 1);
  gmsh::model::mesh::addNodes(2, 1, node_tags, coordinates);
  gmsh::model::mesh::addElementsByType(1, gmsh_triangle, {}, corners);
  gmsh::model::geo::addSurfaceLoop({1}, 1);
  gmsh::model::geo::addVolume({1}, 1);
  gmsh::model::geo::synchronize();
}

void set_options(GmshSession& session, double edge_length) {
  session.set_option("General.NumThreads", 1.);
  session.set_option("Mesh.RandomSeed", 1.);
  // Delaunay. HXT is quicker, but its result differs from run to run.
  session.set_option("Mesh.Algorithm3D", 1.);
  session.set_option("Mesh.MeshSizeMin", 0.);
  session.set_option("Mesh.MeshSizeMax", size_per_edge * edge_length);
  session.set_option("Mesh.MeshSizeFactor", 1.);
  session.set_option("Mesh.MeshSizeExtendFromBoundary", 1.);
  session.set_option("Mesh.MeshSizeFromPoints", 0.);
  session.set_option("Mesh.MeshSizeFromCurvature", 0.);
  session.set_option("Mesh.ElementOrder", 1.);
  session.set_option("Mesh.Optimize", 0.);
  session.set_option("Mesh.OptimizeThreshold", 0.);
}

/// The volume mesh of the current model; nodes are numbered from the tags.
TetMesh extract() {
  std::vector<std::size_t> tags, cell_tags, corners;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters, -1, -1, false, false);
  std::size_t largest_tag = 0;
  for (const std::size_t tag : tags)
    largest_tag = std::max(largest_tag, tag);
  TetMesh mesh;
  mesh.points.resize(largest_tag);
  for (std::size_t i = 0; i < tags.size(); ++i)
    mesh.points[tags[i] - 1] =
        Point<3>(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]);
  gmsh::model::mesh::getElementsByType(gmsh_tetrahedron, cell_tags, corners);
  for (std::size_t c = 0; c < corners.size(); c += 4) {
    std::array<unsigned, 4> cell;
    for (unsigned a = 0; a < 4; ++a)
      cell[a] = unsigned(corners[c + a] - 1);
    const auto& x = mesh.points;
    if (tet_volume(x[cell[0]], x[cell[1]], x[cell[2]], x[cell[3]]) < 0.)
      std::swap(cell[2], cell[3]);
    mesh.cells.push_back(cell);
  }
  return mesh;
}

} // namespace

TetMesh fill_with_tets(const TriangleMesh& surface, double edge_length) {
  GmshSession session("prosup mask mesh");
  set_options(session, edge_length);
  try {
    add_surface(surface);
    gmsh::model::mesh::generate(3);
    for (const double threshold : optimize_thresholds) {
      session.set_option("Mesh.OptimizeThreshold", threshold);
      gmsh::model::mesh::optimize("");
    }
    return extract();
  } catch (...) {
    // gmsh 4.8 throws integers, later versions strings.
    return {};
  }
}

} // namespace prosup::mesh
