#include "prosup/mesh/distributed.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include "box_of_tets.h"
#include "expect_error.h"

namespace prosup::tests {
namespace {

using namespace prosup::mesh;

using dealii::Utilities::MPI::n_mpi_processes;
using dealii::Utilities::MPI::this_mpi_process;

/// A box whose low x face is chest wall, high x face cut plane, and the rest skin.
TetMesh box_with_parts() {
  TetMesh mesh = box_of_tets(Point<3>(), Point<3>(30., 20., 20.), 4);
  for (const auto& cell : mesh.cells)
    for (unsigned a = 0; a < 4; ++a) {
      const std::array<unsigned, 3> face{cell[(a + 1) % 4], cell[(a + 2) % 4], cell[(a + 3) % 4]};
      const auto in_plane = [&](unsigned d, double value) {
        return std::all_of(face.begin(), face.end(),
                           [&](unsigned n) { return mesh.points[n][d] == value; });
      };
      if (in_plane(0, 0.))
        mesh.boundary_faces.push_back({face, BoundaryPart::chest_wall});
      else if (in_plane(0, 30.))
        mesh.boundary_faces.push_back({face, BoundaryPart::cut_plane});
      else if (in_plane(1, 0.) || in_plane(1, 20.) || in_plane(2, 0.) || in_plane(2, 20.))
        mesh.boundary_faces.push_back({face, BoundaryPart::skin});
    }
  return mesh;
}

unsigned expected_part(const Point<3>& centre) {
  return unsigned(centre[0] < 1e-9         ? BoundaryPart::chest_wall
                  : centre[0] > 30. - 1e-9 ? BoundaryPart::cut_plane
                                           : BoundaryPart::skin);
}

void expect_faithful(const TetMesh& mesh, MPI_Comm communicator) {
  // Ranks other than 0 give an empty mesh.
  const bool root = this_mpi_process(communicator) == 0;
  const auto triangulation = make_distributed(root ? mesh : TetMesh(), communicator);
  unsigned n_owned = 0;
  for (const auto& cell : triangulation->active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    ++n_owned;
    const auto id = cell->id().get_coarse_cell_id();
    ASSERT_LT(id, mesh.cells.size());
    EXPECT_EQ(cell->material_id(), mesh.tissue[id]);
    for (unsigned a = 0; a < 4; ++a)
      EXPECT_EQ(cell->vertex(a), mesh.points[mesh.cells[id][a]]);
    for (const unsigned f : cell->face_indices())
      if (cell->face(f)->at_boundary()) {
        EXPECT_EQ(cell->face(f)->boundary_id(), expected_part(cell->face(f)->center()));
      }
  }
  EXPECT_GT(n_owned, 0u);
  EXPECT_EQ(dealii::Utilities::MPI::sum(n_owned, communicator), mesh.cells.size());
}

TEST(Distributed, KeepsCellsVerticesTissuesAndParts) {
  expect_faithful(box_with_parts(), MPI_COMM_WORLD);
}

TEST(Distributed, WorksOnPartOfTheRanks) {
  expect_faithful(box_with_parts(), MPI_COMM_SELF);
  // The two halves hold different meshes at the same time.
  const int rank = int(this_mpi_process(MPI_COMM_WORLD));
  MPI_Comm half;
  MPI_Comm_split(MPI_COMM_WORLD, rank % 2, -rank, &half);
  TetMesh mesh = box_with_parts();
  std::fill(mesh.tissue.begin(), mesh.tissue.end(), std::uint8_t(2 + rank % 2));
  expect_faithful(mesh, half);
  MPI_Comm_free(&half);
}

TEST(Distributed, RefusesBrokenMeshesOnAllRanks) {
  const auto refused = [](const TetMesh& mesh, const std::string& reason) {
    expect_error([&] { make_distributed(mesh, MPI_COMM_WORLD); }, {reason});
  };
  refused(TetMesh(), "needs cells");
  TetMesh inverted = box_with_parts();
  std::swap(inverted.cells[5][0], inverted.cells[5][1]);
  refused(inverted, "Cell 5 is flat or inverted");
  TetMesh torn = box_with_parts();
  torn.cells[7][2] = 100000;
  refused(torn, "Cell 7 names a node");
}

} // namespace
} // namespace prosup::tests
