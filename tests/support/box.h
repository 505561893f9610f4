#ifndef PROSUP_TESTS_BOX_H
#define PROSUP_TESTS_BOX_H

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <functional>
#include <memory>
#include <vector>

namespace prosup::tests {

using Distributed = dealii::parallel::fullydistributed::Triangulation<3>;

/// A box of tetrahedra over the ranks of a communicator, with boundary ids 0
/// to 5 for the faces at low x, high x, low y, high y, low z, high z, and its
/// vertices moved by `transform`.
inline std::unique_ptr<Distributed>
make_box(MPI_Comm communicator, const std::vector<unsigned>& n, const dealii::Point<3>& size,
         const std::function<dealii::Point<3>(const dealii::Point<3>&)>& transform = nullptr) {
  dealii::Triangulation<3> serial;
  dealii::GridGenerator::subdivided_hyper_rectangle_with_simplices(serial, n, dealii::Point<3>(),
                                                                   size);
  for (const auto& cell : serial.active_cell_iterators())
    for (const unsigned f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        for (unsigned d = 0; d < 3; ++d) {
          const double x = cell->face(f)->center()[d];
          if (x < 1e-9 * size[d] || x > (1. - 1e-9) * size[d])
            cell->face(f)->set_boundary_id(2 * d + (x > 0.5 * size[d]));
        }
  if (transform)
    dealii::GridTools::transform(transform, serial);
  dealii::GridTools::partition_triangulation(dealii::Utilities::MPI::n_mpi_processes(communicator),
                                             serial);
  const auto description =
      dealii::TriangulationDescription::Utilities::create_description_from_triangulation(
          serial, communicator);
  auto distributed = std::make_unique<Distributed>(communicator);
  distributed->create_triangulation(description);
  return distributed;
}

} // namespace prosup::tests

#endif
