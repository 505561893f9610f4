#include "box.h"

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

namespace prosup::tests {

using namespace dealii;

std::unique_ptr<Distributed> make_box(MPI_Comm communicator, const std::vector<unsigned>& n,
                                      const Point<3>& size,
                                      const std::function<Point<3>(const Point<3>&)>& transform) {
  Triangulation<3> serial;
  GridGenerator::subdivided_hyper_rectangle_with_simplices(serial, n, Point<3>(), size);
  for (const auto& cell : serial.active_cell_iterators())
    for (const unsigned f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        for (unsigned d = 0; d < 3; ++d) {
          const double x = cell->face(f)->center()[d];
          if (x < 1e-9 * size[d] || x > (1. - 1e-9) * size[d])
            cell->face(f)->set_boundary_id(2 * d + (x > 0.5 * size[d]));
        }
  if (transform)
    GridTools::transform(transform, serial);
  GridTools::partition_triangulation(Utilities::MPI::n_mpi_processes(communicator), serial);
  const auto description =
      TriangulationDescription::Utilities::create_description_from_triangulation(serial,
                                                                                 communicator);
  auto distributed = std::make_unique<Distributed>(communicator);
  distributed->create_triangulation(description);
  return distributed;
}

} // namespace prosup::tests
