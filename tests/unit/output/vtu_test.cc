#include "prosup/output/vtu.h"

#include <gtest/gtest.h>

#include <limits>

#include "affine_mesh.h"
#include "expect_error.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::output;

mesh::UnloadedMesh irrational_mesh() {
  auto box = box_of_tets({-1. / 3., 1. / 7., 100. / 3.}, {20.1, 30.3, 70.7}, 4);
  return affine_mesh(box, stretch_and_shear());
}

// Bitwise: `map` from a result folder must give what the registration gave.
TEST(Vtu, RoundTripIsExact) {
  const TemporaryFolder folder;
  auto mesh = irrational_mesh();
  // Of the cells in the corner of the box: faces in its sides.
  const auto &c = mesh.mesh.cells[0], &d = mesh.mesh.cells[1], &e = mesh.mesh.cells[3];
  mesh.mesh.boundary_faces = {{{c[0], c[2], c[1]}, mesh::BoundaryPart::skin},
                              {{d[0], d[2], d[1]}, mesh::BoundaryPart::chest_wall},
                              {{e[0], e[1], e[3]}, mesh::BoundaryPart::cut_plane}};
  write_mesh(mesh, folder / "", "prone");
  const auto read = read_mesh(folder / "prone_loaded.vtu");
  ASSERT_EQ(read.mesh.boundary_faces.size(), 3u);
  for (unsigned f = 0; f < 3; ++f) {
    EXPECT_EQ(read.mesh.boundary_faces[f].nodes, mesh.mesh.boundary_faces[f].nodes);
    EXPECT_EQ(read.mesh.boundary_faces[f].part, mesh.mesh.boundary_faces[f].part);
  }
  EXPECT_EQ(read.mesh.points, mesh.mesh.points);
  EXPECT_EQ(read.unloaded, mesh.unloaded);
  EXPECT_EQ(read.mesh.cells, mesh.mesh.cells);
  EXPECT_EQ(read.mesh.tissue, mesh.mesh.tissue);
}

TEST(Vtu, CollectionListsBothStates) {
  const TemporaryFolder folder;
  write_mesh(irrational_mesh(), folder / "", "supine");
  const std::string pvd = contents(folder / "supine.pvd");
  EXPECT_NE(pvd.find("timestep=\"0\" file=\"supine_unloaded.vtu\""), std::string::npos) << pvd;
  EXPECT_NE(pvd.find("timestep=\"1\" file=\"supine_loaded.vtu\""), std::string::npos) << pvd;
  EXPECT_TRUE(std::filesystem::exists(folder / "supine_unloaded.vtu"));
}

TEST(Vtu, RefusesBadMeshesAndFolders) {
  const TemporaryFolder folder;
  auto mesh = irrational_mesh();
  expect_error([&] { write_mesh(mesh, folder / "missing", "prone"); }, {"cannot be written"});
  mesh.unloaded[7][2] = std::numeric_limits<double>::quiet_NaN();
  expect_error([&] { write_mesh(mesh, folder / "", "prone"); },
               {"Node 7", "'prone'", "not a finite"});
  mesh = irrational_mesh();
  for (const unsigned node : mesh.mesh.cells[3])
    mesh.unloaded[node] = mesh.unloaded[0];
  expect_error([&] { write_mesh(mesh, folder / "", "prone"); }, {"no volume"});
  mesh.unloaded.pop_back();
  expect_error([&] { write_mesh(mesh, folder / "", "prone"); }, {"125 nodes", "124 unloaded"});
  EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}

TEST(Vtu, RefusesFilesItDidNotWrite) {
  const TemporaryFolder folder;
  expect_error([&] { read_mesh(folder / "no.vtu"); }, {"no.vtu", "does not exist"});
  expect_error([&] { read_mesh(text_file(folder / "bad.vtu", "no mesh")); },
               {"bad.vtu", "damaged"});
  // The unloaded file has no node positions of the unloaded state as data.
  write_mesh(irrational_mesh(), folder / "", "prone");
  expect_error([&] { read_mesh(folder / "prone_unloaded.vtu"); },
               {"prone_unloaded.vtu", "'unloaded'"});
}

} // namespace
} // namespace prosup::tests
