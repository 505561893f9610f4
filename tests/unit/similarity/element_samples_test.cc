#include "prosup/similarity/element_samples.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include "prosup/mesh/tet_mesh.h"
#include "textured_pair.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using similarity::ElementSamples;

Point<3> stretched(const Point<3>& X) {
  return Point<3>(1.3 * X[0], 1.3 * X[1], X[2]);
}

/// The outward normal of the face of make_box() that has the id of cut planes.
Tensor<1, 3> cut_normal() {
  const unsigned id = mesh::boundary_id_of(mesh::BoundaryPart::cut_plane);
  Tensor<1, 3> normal;
  normal[id / 2] = id % 2 == 0 ? -1. : 1.;
  return normal;
}

// The loaded box ends at another place than the unloaded one, and what lies beyond its cut is
// unknown from there on.
TEST(ElementSamples, BeyondACutNothingIsKnown) {
  const TexturedPair pair(stretched, stretched);
  const auto domain = TexturedPair::domain(2., 2);
  const ElementSamples sampled(domain, pair.imaged().prone, nullptr);
  const similarity::Samples& samples = sampled.samples();
  std::vector<int> n_samples(domain.grid.n_voxels(), 0), n_excluded = n_samples;
  for (std::size_t i = 0; i < samples.voxels.size(); ++i) {
    ++n_samples[samples.voxels[i]];
    n_excluded[samples.voxels[i]] += samples.covers[i] == similarity::cover::excluded;
  }
  for (std::vector<int>* counts : {&n_samples, &n_excluded})
    MPI_Allreduce(MPI_IN_PLACE, counts->data(), static_cast<int>(counts->size()), MPI_INT, MPI_SUM,
                  MPI_COMM_WORLD);
  const Tensor<1, 3> normal = cut_normal();
  const Point<3> high(40., 48., 56.);
  double end = 0.; // of the unloaded box along the normal
  for (unsigned d = 0; d < 3; ++d)
    end += std::max(normal[d], 0.) * high[d];
  std::size_t v = 0, n_beyond = 0;
  for (std::size_t k = 0; k < domain.grid.size[2]; ++k)
    for (std::size_t j = 0; j < domain.grid.size[1]; ++j)
      for (std::size_t i = 0; i < domain.grid.size[0]; ++i, ++v) {
        const double height = domain.grid.physical(double(i), double(j), double(k)) * normal;
        ASSERT_LE(n_samples[v], 1);
        if (height > end + 5.) { // two layers of 2 mm are samples around the box
          ASSERT_EQ(n_excluded[v], 1);
        }
        if (height <= end) {
          ASSERT_EQ(n_excluded[v], 0);
        }
        n_beyond += height > end + 5.;
      }
  EXPECT_GT(n_beyond, 1000u);
}

} // namespace
} // namespace prosup::tests
