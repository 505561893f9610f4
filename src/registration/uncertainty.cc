#include "prosup/registration/uncertainty.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "posterior.h"
#include "prosup/core/collective.h"
#include "prosup/mechanics/body/boundary.h"
#include "prosup/mesh/tet_mesh.h"
#include "prosup/registration/element_breast.h"
#include "prosup/similarity/image_force.h"

namespace prosup::registration {

using namespace dealii;
using mechanics::node_value;
using mechanics::NodeVector;
using mechanics::Supports;

namespace {

constexpr auto chest_wall = mesh::boundary_id_of(mesh::BoundaryPart::chest_wall);
constexpr auto cut_plane = mesh::boundary_id_of(mesh::BoundaryPart::cut_plane);

// What gives way where the model holds tissue: the thickness of tissue of the breast's stiffness
// behind the chest wall (the error of masks and mesh there) and beyond a cut plane.
constexpr double chest_layer = 10., cut_layer = 40.; // mm
constexpr double level = 2.;                         // mm, of the voxels for H

// Fitted to reference cases, see docs/uncertainty.md.
constexpr double image_weight = 10.;  // w: the model is trusted less than by the image forces
constexpr double prior = 3900.;       // theta/V_v of a right model, Pa
constexpr double misfit_part = 0.6;   // g, 1/mm^2
constexpr double cut_part = 1.9;      // c
constexpr double cut_reach = 7.5;     // l, mm
constexpr double wall_part = 27.;     // e
constexpr double wall_reach = 11.;    // m, mm
constexpr double usual_motion = 0.87; // D0, mm

/// The breast on springs instead of supports that do not give way, at its present X.
struct YieldingBreast {
  NodeVector unloaded;
  Supports supports;

  YieldingBreast(const ElementBreast& breast, double shear_modulus)
      : unloaded(breast.unloading().unloaded()), supports(breast.body()) {
    unloaded.update_ghost_values();
    supports.add_springs({chest_wall}, shear_modulus / chest_layer);
    supports.add_springs({cut_plane}, shear_modulus / cut_layer);
    supports.set_reference(unloaded);
  }
};

/// The volume of the larger voxel of both images, mm^3.
double voxel_volume(const BreastPair& pair, const ComparedImages& images) {
  double largest = 0.;
  pair.for_each([&](Position position, Breast&) {
    const auto& spacing = images.images[position].grid.spacing;
    largest = std::max(largest, spacing[0] * spacing[1] * spacing[2]);
  });
  return Utilities::MPI::max(largest, pair.ranks().world());
}

/// The sum over both breasts of the root mean square of |X - X0|, mm.
double distance_moved(const BreastPair& pair, const PerPosition<NodeVector>& start) {
  double total = 0.;
  for (const Position position : both_positions) {
    double sums[2] = {0., 0.};
    if (pair.ranks().holds(position)) {
      const ElementBreast& breast = *pair[position].elements();
      for (unsigned node = 0; node < breast.body().n_owned_nodes(); ++node, ++sums[1])
        sums[0] +=
            (node_value(breast.unloading().unloaded(), node) - node_value(start[position], node))
                .norm_square();
    }
    Utilities::MPI::sum(ArrayView<const double>(sums, 2), pair.ranks().world(),
                        ArrayView<double>(sums, 2));
    total += std::sqrt(sums[0] / sums[1]);
  }
  return total;
}

/// The distance of each owned node from the closest node of a part of the boundary, mm; infinite if
/// there is none.
std::vector<double> distance_from(dealii::types::boundary_id part, const mechanics::Body& body,
                                  const NodeVector& unloaded) {
  std::vector<Point<3>> mine;
  const std::vector<bool> is_part = nodes_on_boundary(body, {part});
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    if (is_part[node])
      mine.emplace_back(node_value(unloaded, node));
  const std::vector<Point<3>> all = all_gathered(mine, body.communicator());
  std::vector<double> distances;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    const Point<3> x(node_value(unloaded, node));
    double least = std::numeric_limits<double>::infinity();
    for (const Point<3>& point : all)
      least = std::min(least, x.distance_square(point));
    distances.push_back(std::sqrt(least));
  }
  return distances;
}

/// max(D^2 - D0^2, 0), mm^2: by how much the model is more wrong than usual.
double misfit(double moved) {
  return std::max(moved * moved - usual_motion * usual_motion, 0.);
}

/// What a wrong model leaves along one axis, mm^2: the second term of C of UncertaintyParameters.
std::vector<double> left_by_model(const mechanics::Body& body, const NodeVector& unloaded,
                                  double moved) {
  const std::vector<double> from_cut = distance_from(cut_plane, body, unloaded),
                            from_wall = distance_from(chest_wall, body, unloaded);
  std::vector<double> variances;
  for (std::size_t node = 0; node < from_cut.size(); ++node)
    variances.push_back((cut_part * moved * moved * std::exp(-2. * from_cut[node] / cut_reach) +
                         wall_part * misfit(moved) * std::exp(-2. * from_wall[node] / wall_reach)) /
                        3.);
  return variances;
}

/// Values at owned nodes on the nodes of the mesh, on the first rank of the breast.
std::vector<NodeCovariance> at_mesh_nodes(const ElementBreast& breast,
                                          const std::vector<NodeCovariance>& mine) {
  NodeVector parts[2]; // diagonal, and the rest
  for (unsigned half = 0; half < 2; ++half) {
    breast.body().initialize(parts[half]);
    for (unsigned node = 0; node < mine.size(); ++node)
      for (unsigned c = 0; c < 3; ++c)
        parts[half].local_element(3 * node + c) = mine[node].access_raw_entry(3 * half + c);
    parts[half].update_ghost_values();
  }
  const mesh::TetMesh mesh = breast.mesh().mesh;
  std::vector<NodeCovariance> covariances(mesh.points.size());
  for (unsigned half = 0; half < 2; ++half) {
    const auto at_cells = breast.body().gather_at_cells(parts[half]);
    for (std::size_t cell = 0; cell < at_cells.size(); ++cell)
      for (unsigned a = 0; a < 4; ++a)
        for (unsigned c = 0; c < 3; ++c)
          covariances[mesh.cells[cell][a]].access_raw_entry(3 * half + c) = at_cells[cell][a][c];
  }
  return covariances;
}

/// Sends what the first ranks of both breasts have to rank 0.
void collect(const RankSplit& ranks, UncertaintyParameters::Covariances& covariances) {
  const int rank = Utilities::MPI::this_mpi_process(ranks.world());
  for (const Position position : both_positions) {
    const int holder = ranks.first_rank(position);
    if (rank == 0 || rank == holder)
      transfer(covariances[position], holder, 0, ranks.world());
  }
  if (rank != 0)
    covariances = {};
}

} // namespace

UncertaintyParameters::UncertaintyParameters() : ParameterAcceptor("Uncertainty") {}

void UncertaintyParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Wanted", wanted, "Whether the result tells how sure mapped points are.");
  prm.add_parameter("Samples", n_samples_,
                    "Number of random displacements from which variances are taken; these are off "
                    "by a part of (2/n)^1/2. Units: none.",
                    Patterns::Integer(4, 10000));
}

UncertaintyParameters::Covariances
UncertaintyParameters::covariances(const BreastPair& pair, const ComparedImages& images,
                                   const PerPosition<NodeVector>& start) const {
  Covariances covariances;
  if (!wanted || !pair.consists_of_elements())
    return covariances;
  const Comparison comparison(pair, images, Compared::images, level);
  const double shear_modulus = pair.properties().tissue.shear_modulus,
               moved = distance_moved(pair, start), voxel = voxel_volume(pair, images);
  PerPosition<std::unique_ptr<YieldingBreast>> breasts;
  PerPosition<similarity::ImagedBody> bodies;
  pair.for_each([&](Position position, Breast& breast) {
    breasts[position] = std::make_unique<YieldingBreast>(*breast.elements(), shear_modulus);
    bodies[position] = {&breast.elements()->body(), &breasts[position]->unloaded,
                        &comparison.images()[position]};
  });
  const similarity::SimilarityResult found =
      similarity::ImageForce(comparison.metric(), pair.ranks().world())
          .evaluate(comparison.domain(), bodies, similarity::Variable::unloaded, true);
  const double kappa =
      found.residual_variance > 0. ? image_weight * shear_modulus / found.residual_variance : 0.;
  pair.for_each([&](Position position, Breast& breast) {
    const ElementBreast& elements = *breast.elements();
    const YieldingBreast& yielding = *breasts[position];
    const PosteriorBody body{yielding.supports, elements.material(), yielding.unloaded};
    std::vector<NodeCovariance> mine =
        sampled_inverse(body, found.stiffness[position], 2. * kappa, n_samples_);
    const std::vector<double> wrong = left_by_model(elements.body(), yielding.unloaded, moved);
    const double theta = prior * voxel * (1. + misfit_part * misfit(moved));
    for (std::size_t node = 0; node < mine.size(); ++node)
      mine[node] = theta * mine[node] + wrong[node] * unit_symmetric_tensor<3>();
    covariances[position] = at_mesh_nodes(elements, mine);
  });
  collect(pair.ranks(), covariances);
  return covariances;
}

} // namespace prosup::registration
