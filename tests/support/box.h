#ifndef PROSUP_TESTS_BOX_H
#define PROSUP_TESTS_BOX_H

#include <deal.II/distributed/fully_distributed_tria.h>

#include <functional>
#include <memory>
#include <vector>

namespace prosup::tests {

using Distributed = dealii::parallel::fullydistributed::Triangulation<3>;

/// A box of tetrahedra over the ranks of a communicator, with boundary ids 0
/// to 5 for the faces at low x, high x, low y, high y, low z, high z, and its
/// vertices moved by `transform`.
std::unique_ptr<Distributed>
make_box(MPI_Comm communicator, const std::vector<unsigned>& n, const dealii::Point<3>& size,
         const std::function<dealii::Point<3>(const dealii::Point<3>&)>& transform = nullptr);

} // namespace prosup::tests

#endif
