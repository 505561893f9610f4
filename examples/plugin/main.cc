// An outside deal.II program that uses prosup as a library. It owns everything a
// host program owns: MPI, a communicator, triangulations and a ParameterHandler.
//
// A textured block hangs from its back under prone gravity, and is pressed to it
// under supine gravity. From the two loaded shapes and their images the program
// finds the unloaded shape twice, with a shear modulus that is 40% too stiff, so
// that the two disagree; image forces then bring them together.
#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <prosup/core/error.h>
#include <prosup/mechanics/laws/material.h>
#include <prosup/similarity/domain.h>
#include <prosup/similarity/image_force.h>
#include <prosup/similarity/sum_of_squared_differences.h>
#include <prosup/unloading/unloading.h>

#include <cmath>
#include <iostream>
#include <memory>

#include "textured_block.h"

using namespace dealii;
using namespace prosup;
using mechanics::NodeVector;
using unloading::Unloading;
using unloading::UnloadingParameters;

namespace {

constexpr double force_weight = 60.;        // kappa, Pa: a part of the shear modulus
const std::set<types::boundary_id> held{1}; // the back of a block
constexpr double voxel_edge = 3.;           // of the common unloaded grid, mm
constexpr unsigned n_updates = 8;
constexpr unsigned steps_per_update = 60;

/// One state (prone or supine) of the block, as it would come from a scanner:
/// a mesh of the loaded shape and an image; and the search for its unloaded one.
struct LoadedBlock {
  LoadedBlock(const BlockParameters& block, const UnloadingParameters& parameters,
              const Tensor<1, 3>& gravity, MPI_Comm communicator) {
    Triangulation<3> mesh;
    make_block(block, mesh);
    load(mesh, block, parameters, gravity, communicator);
    triangulation = distribute(mesh, communicator);
    body = std::make_unique<mechanics::Body>(*triangulation);
    supports = std::make_unique<mechanics::Supports>(*body, held);
    unloading = std::make_unique<Unloading>(parameters, *supports, gravity);
    unloading->set_material(
        {mechanics::lame_parameters(block.assumed_shear_modulus, block.poisson_ratio)});
  }

  similarity::LoadedState state() const { return {body.get(), &unloading->unloaded(), &image}; }

  std::unique_ptr<parallel::fullydistributed::Triangulation<3>> triangulation;
  std::unique_ptr<mechanics::Body> body;
  std::unique_ptr<mechanics::Supports> supports;
  std::unique_ptr<Unloading> unloading;
  image::ScalarImage image;

private:
  /// Forward simulation with the true material; moves `mesh` to the loaded shape.
  void load(Triangulation<3>& mesh, const BlockParameters& block,
            const UnloadingParameters& parameters, const Tensor<1, 3>& gravity,
            MPI_Comm communicator) {
    const auto distributed = distribute(mesh, communicator);
    const mechanics::Body reference(*distributed);
    mechanics::Supports supports(reference, held);
    Unloading loading(parameters, supports, gravity);
    loading.hold_reference(); // X stays where it is: a plain simulation
    loading.set_material(
        {mechanics::lame_parameters(block.true_shear_modulus, block.poisson_ratio)});
    loading.run();
    NodeVector loaded = loading.displacement();
    loaded += reference.vertex_positions();
    loaded.update_ghost_values();
    image = scan(reference, loaded);
    move_vertices(mesh, reference, loaded);
  }
};

/// Mean distance of the unloaded positions of both blocks, mm, on rank 0.
double mean_distance(const LoadedBlock& a, const LoadedBlock& b) {
  const auto Xa = a.body->gather_at_cells(a.unloading->unloaded());
  const auto Xb = b.body->gather_at_cells(b.unloading->unloaded());
  double sum = 0.;
  for (std::size_t cell = 0; cell < Xa.size(); ++cell)
    for (unsigned v = 0; v < 4; ++v)
      sum += Xa[cell][v].distance(Xb[cell][v]);
  return sum / (4. * static_cast<double>(a.body->n_global_cells()));
}

/// Returns whether the image forces brought the two shapes together.
bool run(const BlockParameters& block, const UnloadingParameters& parameters, MPI_Comm world) {
  LoadedBlock prone(block, parameters, Tensor<1, 3>({0., -1., 0.}), world);
  LoadedBlock supine(block, parameters, Tensor<1, 3>({0., 1., 0.}), world);
  prone.unloading->run();
  supine.unloading->run();

  // The grid on which both images are compared. Around this block is only air.
  similarity::SimilarityDomain domain;
  domain.grid =
      similarity::common_unloaded_grid({prone.state(), supine.state()}, voxel_edge, 15., world);
  domain.no_air.assign(domain.grid.n_voxels(), false);
  const similarity::ImageForce image_force(std::make_shared<similarity::SumOfSquaredDifferences>(),
                                           world);

  const auto report = [&](const char* when, double ssd) {
    const double distance = Utilities::MPI::broadcast(world, mean_distance(prone, supine), 0);
    if (Utilities::MPI::this_mpi_process(world) == 0)
      std::cout << when << ": SSD " << ssd << " mm^3, mean distance of the unloaded shapes "
                << distance << " mm\n";
    return std::make_pair(ssd, distance);
  };
  auto similarity = image_force.evaluate(domain, {prone.state(), supine.state()});
  const auto before = report("Unloaded    ", similarity.value);
  for (unsigned update = 0; update < n_updates; ++update) {
    for (const unsigned s : {0u, 1u}) {
      Unloading& unloading = s == 0 ? *prone.unloading : *supine.unloading;
      similarity.forces[s] *= force_weight;
      unloading.add_force(similarity.forces[s], 0.5 * steps_per_update * unloading.time_step());
      unloading.advance(steps_per_update);
    }
    similarity = image_force.evaluate(domain, {prone.state(), supine.state()});
  }
  const auto after = report("Image forces", similarity.value);
  return after.first < 0.5 * before.first && after.second < 0.5 * before.second;
}

} // namespace

int main(int argc, char** argv) {
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  MPI_Comm communicator;
  MPI_Comm_dup(MPI_COMM_WORLD, &communicator);
  bool together = false;
  try {
    BlockParameters block;          // section Block: ours
    UnloadingParameters parameters; // section Unloading: prosup's
    ParameterHandler handler;
    ParameterAcceptor::declare_all_parameters(handler);
    if (argc > 1)
      handler.parse_input(argv[1]);
    ParameterAcceptor::parse_all_parameters(handler);
    together = run(block, parameters, communicator);
    if (!together)
      std::cerr << "The image forces did not bring the unloaded shapes together.\n";
  } catch (const std::exception& error) { // prosup::Error is one; all ranks throw alike
    std::cerr << error.what() << '\n';
  }
  MPI_Comm_free(&communicator);
  return together ? 0 : 1;
}
