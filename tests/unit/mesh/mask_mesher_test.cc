#include "prosup/mesh/mask_mesher.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "prosup/mesh/quality.h"
#include "test_labels.h"

namespace prosup::tests {
namespace {

using namespace prosup::mesh;

TetMesh mesh_of(const image::LabelImage& labels, double edge_length) {
  const Labels label_values;
  MaskMesher mesher(label_values);
  mesher.edge_length = edge_length;
  return mesher.mesh(labels);
}

/// Largest distance of boundary nodes to a sphere about the origin, mm.
double largest_distance_to_sphere(const TetMesh& mesh, double radius) {
  double largest = 0.;
  for (const BoundaryFace& face : mesh.boundary_faces)
    for (const unsigned node : face.nodes)
      largest = std::max(largest, std::abs(mesh.points[node].norm() - radius));
  return largest;
}

TEST(MaskMesher, BallHasItsVolumeSurfaceAndGoodCells) {
  constexpr double radius = 25., h = 8.;
  const TetMesh mesh = mesh_of(ball_labels(centred_cube(60), radius), h);
  const MeshQuality quality = measure_quality(mesh);
  EXPECT_NEAR(quality.volume_mm3, ball_volume(radius), 0.01 * ball_volume(radius));
  // Nodes lie off the sphere by the height of the chords, h^2/(12 R) = 0.2 mm.
  EXPECT_LT(largest_distance_to_sphere(mesh, radius), 0.6);
  EXPECT_GT(quality.min_quality, 0.3);
  EXPECT_GT(quality.mean_quality, 0.75);
  EXPECT_GT(quality.min_height, 0.35 * h);
  EXPECT_NEAR(quality.mean_edge, h, 0.25 * h);
  EXPECT_NEAR(area_of(mesh, BoundaryPart::skin), 4. * M_PI * radius * radius,
              0.03 * 4. * M_PI * radius * radius);
  EXPECT_EQ(area_of(mesh, BoundaryPart::cut_plane) + area_of(mesh, BoundaryPart::chest_wall), 0.);
}

TEST(MaskMesher, NodesAreUsedAndBoundaryIsClosed) {
  const TetMesh mesh = mesh_of(ball_labels(centred_cube(50), 20.), 9.);
  std::set<unsigned> used;
  for (const auto& cell : mesh.cells) {
    used.insert(cell.begin(), cell.end());
    EXPECT_GT(tet_volume(mesh.points[cell[0]], mesh.points[cell[1]], mesh.points[cell[2]],
                         mesh.points[cell[3]]),
              0.);
  }
  EXPECT_EQ(used.size(), mesh.points.size());
  // Each edge is passed once in each direction, and the normals point outwards.
  std::map<std::array<unsigned, 2>, int> edges;
  double volume = 0.;
  for (const BoundaryFace& face : mesh.boundary_faces) {
    for (unsigned a = 0; a < 3; ++a)
      ++edges[{face.nodes[a], face.nodes[(a + 1) % 3]}];
    volume += tet_volume(Point<3>(), mesh.points[face.nodes[0]], mesh.points[face.nodes[1]],
                         mesh.points[face.nodes[2]]);
  }
  for (const auto& [edge, n] : edges) {
    EXPECT_EQ(n, 1);
    EXPECT_EQ(edges.count({edge[1], edge[0]}), 1u);
  }
  EXPECT_NEAR(volume, measure_quality(mesh).volume_mm3, 1e-6 * volume);
}

// The ball goes on beyond x = 10 mm, where the image shows nothing.
TEST(MaskMesher, TissueIsCutOffByWhatIsUnknown) {
  constexpr double radius = 25., plane = 10.;
  image::LabelImage labels = ball_labels(centred_cube(60), radius);
  const Labels meaning;
  const auto& size = labels.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i)
        if (labels.grid.physical(double(i), double(j), double(k))[0] > plane)
          labels(i, j, k) = std::uint8_t(meaning.unknown);
  const TetMesh mesh = mesh_of(labels, 8.);
  const double disc = M_PI * (radius * radius - plane * plane);
  EXPECT_NEAR(area_of(mesh, BoundaryPart::cut_plane), disc, 0.15 * disc); // its rim is rounded
  EXPECT_NEAR(area_of(mesh, BoundaryPart::skin), 2. * M_PI * radius * (radius + plane),
              0.15 * 2. * M_PI * radius * (radius + plane));
}

TEST(MaskMesher, SameInputGivesSameMesh) {
  const auto labels = ball_labels(centred_cube(40), 16.);
  const TetMesh first = mesh_of(labels, 7.), second = mesh_of(labels, 7.);
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.cells, second.cells);
}

TEST(MaskMesher, BoxAtTheBorderHasExactPlanesAndTheRightParts) {
  // Chest below z = -5, air above z = 10; the tissue touches the other borders.
  const auto grid =
      centred_grid({40, 30, 30}, dealii::Tensor<1, 3>({1., 1.5, 1.}), image::VoxelGrid().direction);
  const TetMesh mesh = mesh_of(
      make_labels(grid, [](const Point<3>& x) { return x[2] < -5.   ? 1u
                                                       : x[2] > 10. ? 0u
                                                                    : 2u; }),
      7.);
  const double lx = 40., ly = 45., lz = 15.;
  EXPECT_NEAR(measure_quality(mesh).volume_mm3, lx * ly * lz, 0.002 * lx * ly * lz);
  EXPECT_GT(measure_quality(mesh).min_height, 0.35 * 7.);
  EXPECT_NEAR(area_of(mesh, BoundaryPart::cut_plane), 2. * (lx + ly) * lz,
              0.01 * 2. * (lx + ly) * lz);
  EXPECT_NEAR(area_of(mesh, BoundaryPart::chest_wall), lx * ly, 0.01 * lx * ly);
  EXPECT_NEAR(area_of(mesh, BoundaryPart::skin), lx * ly, 0.01 * lx * ly);
  for (const BoundaryFace& face : mesh.boundary_faces) {
    std::array<bool, 2> on_border{true, true};
    for (const unsigned node : face.nodes) {
      const Point<3>& x = mesh.points[node];
      on_border[0] = on_border[0] && std::abs(std::abs(x[0]) - lx / 2.) < 1e-9;
      on_border[1] = on_border[1] && std::abs(std::abs(x[1]) - ly / 2.) < 1e-9;
      if (face.part != BoundaryPart::cut_plane) {
        EXPECT_NEAR(x[2], face.part == BoundaryPart::chest_wall ? -5. : 10., 0.2);
      }
    }
    EXPECT_EQ(face.part == BoundaryPart::cut_plane, on_border[0] || on_border[1]);
  }
}

TEST(MaskMesher, MaskThatFillsTheImageIsAnExactBox) {
  const auto labels = make_labels(centred_cube(30), [](const Point<3>&) { return 3u; });
  const TetMesh mesh = mesh_of(labels, 9.);
  EXPECT_NEAR(measure_quality(mesh).volume_mm3, 27000., 1e-6);
  EXPECT_NEAR(area_of(mesh, BoundaryPart::cut_plane), 5400., 1e-6);
  EXPECT_EQ(std::count(mesh.tissue.begin(), mesh.tissue.end(), 3), long(mesh.cells.size()));
}

TEST(MaskMesher, MaskThatTouchesAllFacesIsCutThere) {
  // A ball that sticks out of all six faces of a cube: the six cut planes are discs.
  constexpr double radius = 19., half = 15.;
  const TetMesh mesh = mesh_of(ball_labels(centred_cube(30), radius), 7.);
  const double cap = radius - half;
  const double volume = ball_volume(radius) - 6. * M_PI * cap * cap * (radius - cap / 3.);
  const double discs = 6. * M_PI * (radius * radius - half * half);
  EXPECT_NEAR(measure_quality(mesh).volume_mm3, volume, 0.01 * volume);
  EXPECT_GT(measure_quality(mesh).min_height, 0.25 * 7.);
  // Here the surface meets the planes at 52 degrees: a shift of 0.25 mm, as chords
  // ask for, widens a disc by 0.4 mm or 7 % of its area.
  EXPECT_NEAR(area_of(mesh, BoundaryPart::cut_plane), discs, 0.07 * discs);
}

TEST(MaskMesher, KeepsTheLargestPartAndFillsItsHoles) {
  const Point<3> small_centre(22., 22., 22.);
  const TetMesh mesh =
      mesh_of(make_labels(centred_cube(60),
                          [&](const Point<3>& x) {
                            const bool in_shell = x.norm() < 22. && x.norm() > 9.;
                            return in_shell || x.distance(small_centre) < 6. ? 2u : 0u;
                          }),
              8.);
  EXPECT_NEAR(measure_quality(mesh).volume_mm3, ball_volume(22.), 0.01 * ball_volume(22.));
  EXPECT_LT(largest_distance_to_sphere(mesh, 22.), 0.7);
}

TEST(MaskMesher, BridgeOfOneVoxelIsCut) {
  const Point<3> large(-14., 0.5, 0.5), small(24., 0.5, 0.5);
  const auto grid =
      centred_grid({80, 50, 50}, dealii::Tensor<1, 3>({1., 1., 1.}), image::VoxelGrid().direction);
  const TetMesh mesh =
      mesh_of(make_labels(grid,
                          [&](const Point<3>& x) {
                            const bool on_bridge = std::abs(x[1] - 0.5) < 0.1 &&
                                                   std::abs(x[2] - 0.5) < 0.1 && x[0] > large[0] &&
                                                   x[0] < small[0];
                            return x.distance(large) < 19. || x.distance(small) < 11. || on_bridge
                                       ? 2u
                                       : 0u;
                          }),
              7.);
  EXPECT_NEAR(measure_quality(mesh).volume_mm3, ball_volume(19.), 0.015 * ball_volume(19.));
}

TEST(MaskMesher, TissueIsSampledFromTheLabels) {
  const TetMesh mesh = mesh_of(make_labels(centred_cube(60),
                                           [](const Point<3>& x) {
                                             return x.norm() < 15. ? 3u : x.norm() < 26. ? 2u : 0u;
                                           }),
                               6.);
  double gland = 0.;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto x = cell_corners(mesh, c);
    gland += mesh.tissue[c] == 3 ? tet_volume(x[0], x[1], x[2], x[3]) : 0.;
  }
  EXPECT_NEAR(gland, ball_volume(15.), 0.1 * ball_volume(15.));
}

} // namespace
} // namespace prosup::tests
