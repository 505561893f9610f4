#include "textured_block.h"

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>
#include <prosup/mesh/scan_conversion.h>

#include <algorithm>
#include <cmath>

using namespace dealii;
using prosup::mechanics::Body;
using prosup::mechanics::node_value;
using prosup::mechanics::NodeVector;

BlockParameters::BlockParameters() : ParameterAcceptor("Block") {}

void BlockParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Edge", edge, "Units: mm.", Patterns::Double(1.));
  prm.add_parameter("Subdivisions", n_subdivisions, "Along each edge.", Patterns::Integer(1));
  prm.add_parameter("True shear modulus", true_shear_modulus, "Units: Pa.", Patterns::Double(1.));
  prm.add_parameter("Assumed shear modulus", assumed_shear_modulus, "Units: Pa.",
                    Patterns::Double(1.));
  prm.add_parameter("Poisson ratio", poisson_ratio, "Units: none.", Patterns::Double(0., 0.49));
}

void make_block(const BlockParameters& parameters, Triangulation<3>& block) {
  const double edge = parameters.edge;
  const std::vector<unsigned> n(3, parameters.n_subdivisions);
  GridGenerator::subdivided_hyper_rectangle_with_simplices(block, n, Point<3>(),
                                                           Point<3>(edge, edge, edge));
  for (const auto& cell : block.active_cell_iterators())
    for (const unsigned f : cell->face_indices())
      if (cell->face(f)->at_boundary() && cell->face(f)->center()[1] > edge * (1. - 1e-9))
        cell->face(f)->set_boundary_id(1);
}

std::unique_ptr<parallel::fullydistributed::Triangulation<3>> distribute(Triangulation<3>& mesh,
                                                                         MPI_Comm communicator) {
  GridTools::partition_triangulation(Utilities::MPI::n_mpi_processes(communicator), mesh);
  auto distributed = std::make_unique<parallel::fullydistributed::Triangulation<3>>(communicator);
  distributed->create_triangulation(
      TriangulationDescription::Utilities::create_description_from_triangulation(mesh,
                                                                                 communicator));
  return distributed;
}

prosup::mesh::TetMesh whole_mesh(const Triangulation<3>& mesh) {
  prosup::mesh::TetMesh whole;
  whole.points = mesh.get_vertices();
  for (const auto& cell : mesh.active_cell_iterators())
    whole.cells.push_back({cell->vertex_index(0), cell->vertex_index(1), cell->vertex_index(2),
                           cell->vertex_index(3)});
  whole.tissue.resize(whole.cells.size(), 0);
  return whole;
}

void move_vertices(Triangulation<3>& mesh, const Body& body, const NodeVector& positions) {
  const auto at_cells =
      Utilities::MPI::broadcast(body.communicator(), body.gather_at_cells(positions), 0);
  for (const auto& cell : mesh.active_cell_iterators())
    for (const unsigned v : cell->vertex_indices())
      cell->vertex(v) = at_cells[cell->active_cell_index()][v];
}

prosup::image::ScalarImage scan(const Body& body, const NodeVector& loaded) {
  const auto texture = [](const Point<3>& X) {
    return 0.6 + 0.13 * (std::sin(0.25 * X[0]) + std::sin(0.25 * X[1]) + std::sin(0.25 * X[2]));
  };
  Point<3> low, high;
  for (unsigned d = 0; d < 3; ++d) {
    low[d] = high[d] = node_value(loaded, 0)[d];
    for (unsigned node = 0; node < body.n_local_nodes(); ++node) {
      low[d] = std::min(low[d], node_value(loaded, node)[d]);
      high[d] = std::max(high[d], node_value(loaded, node)[d]);
    }
    low[d] = Utilities::MPI::min(low[d], body.communicator());
    high[d] = Utilities::MPI::max(high[d], body.communicator());
  }
  prosup::image::ScalarImage image(prosup::image::grid_around(low, high, 1.5, 10.));
  for (const auto& cell : body.cells()) {
    std::array<Point<3>, 4> x, X;
    for (unsigned a = 0; a < 4; ++a) {
      x[a] = Point<3>(node_value(loaded, cell[a]));
      X[a] = Point<3>(node_value(body.vertex_positions(), cell[a]));
    }
    prosup::mesh::scan_convert_tet(
        image.grid, x, [&](std::size_t i, std::size_t j, std::size_t k, const auto& weights) {
          Point<3> material_point;
          for (unsigned a = 0; a < 4; ++a)
            material_point += weights[a] * X[a];
          image(i, j, k) = static_cast<float>(texture(material_point));
        });
  }
  // Each rank has drawn its own cells on 0.
  MPI_Allreduce(MPI_IN_PLACE, image.values.data(), static_cast<int>(image.values.size()), MPI_FLOAT,
                MPI_MAX, body.communicator());
  return image;
}
