// An outside deal.II program that uses prosup as a library. It owns everything a host program owns:
// MPI, a communicator, triangulations and a ParameterHandler.
//
// A textured block hangs from its back under prone gravity, and is pressed to it under supine
// gravity. From the two loaded shapes and their images the program finds the unloaded shape twice,
// with a shear modulus that is 40% too stiff, so that the two disagree; prosup's default image
// forces then bring them together.
#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <prosup/core/error.h>
#include <prosup/registration/comparison.h>
#include <prosup/registration/element_breast.h>
#include <prosup/registration/image_force_registration.h>
#include <prosup/similarity/similarity_parameters.h>

#include <iostream>

#include "textured_block.h"

using namespace dealii;
using namespace prosup;
using namespace prosup::registration;

namespace {

const std::set<types::boundary_id> held{1}; // the back of a block

/// All sections of the parameter file: the host's and prosup's.
struct Parameters {
  BlockParameters block;
  Labels labels;
  mechanics::TissueMaterial material{labels};
  unloading::UnloadingParameters unloading;
  similarity::SimilarityParameters similarity;
  ImageForceRegistration image_forces;
};

Tensor<1, 3> gravity(Position position) {
  return Tensor<1, 3>({0., position == Position::prone ? -1. : 1., 0.});
}

/// Moves `mesh` to its loaded shape, by a forward simulation with the true material, and returns
/// its image: what would come from a scanner.
image::ScalarImage load(Triangulation<3>& mesh, const Parameters& parameters, Position position,
                        MPI_Comm communicator) {
  const auto distributed = distribute(mesh, communicator);
  const mechanics::Body block(*distributed);
  mechanics::Supports supports(block, held);
  unloading::Unloading loading(parameters.unloading, supports, gravity(position));
  loading.hold_reference(); // a plain simulation
  loading.set_material(mechanics::lame_parameters(parameters.block.true_shear_modulus,
                                                  parameters.block.poisson_ratio));
  loading.run();
  mechanics::NodeVector loaded = loading.displacement();
  loaded += block.vertex_positions();
  loaded.update_ghost_values();
  const image::ScalarImage image = scan(block, loaded);
  move_vertices(mesh, block, loaded);
  return image;
}

/// One loaded block, as prosup takes it.
std::unique_ptr<Breast> make_breast(const Parameters& parameters, Position position,
                                    image::ScalarImage& image, MPI_Comm communicator) {
  Triangulation<3> mesh;
  make_block(parameters.block, mesh);
  image = load(mesh, parameters, position, communicator);
  ElementBreast::Parts parts;
  parts.mesh = whole_mesh(mesh);
  parts.body = std::make_unique<mechanics::Body>(*distribute(mesh, communicator));
  parts.supports = std::make_unique<mechanics::Supports>(*parts.body, held);
  parts.unloading = std::make_unique<unloading::Unloading>(parameters.unloading, *parts.supports,
                                                           gravity(position));
  return std::make_unique<ElementBreast>(position, std::move(parts), parameters.material);
}

/// Mean distance of the unloaded positions of both blocks, mm; on rank 0.
double mean_distance(const BreastPair& pair) {
  const auto meshes = pair.meshes();
  const std::vector<Point<3>>&prone = meshes.prone.unloaded, &supine = meshes.supine.unloaded;
  double sum = 0.;
  for (std::size_t node = 0; node < prone.size(); ++node)
    sum += prone[node].distance(supine[node]);
  return sum / static_cast<double>(prone.size());
}

/// Returns whether the image forces brought the two shapes together.
bool run(const Parameters& parameters, MPI_Comm world) {
  const RankSplit ranks(world); // half of the ranks for each block
  const BlockParameters& block = parameters.block;
  PerPosition<image::ScalarImage> images;
  BreastPair pair(ranks, {}, [&](Position position, MPI_Comm group) {
    return make_breast(parameters, position, images[position], group);
  });
  pair.set_properties({{block.assumed_shear_modulus, block.poisson_ratio, 1.}, 0.});
  pair.unload();

  const similarity::Scene scene{}; // around this block is only air
  const ComparedImages compared{images, scene, parameters.similarity.make_metric()};
  const auto report = [&](const char* when) {
    const double ssd = Comparison(pair, compared, Compared::images, 2.).value();
    const double distance = Utilities::MPI::broadcast(world, mean_distance(pair), 0);
    if (Utilities::MPI::this_mpi_process(world) == 0)
      std::cout << when << ": SSD " << ssd << " mm^3, mean distance of the unloaded shapes "
                << distance << " mm\n";
    return std::make_pair(ssd, distance);
  };
  const auto before = report("Unloaded    ");
  parameters.image_forces.run(pair, compared, Log());
  const auto after = report("Image forces");
  return after.first < 0.5 * before.first && after.second < 0.5 * before.second;
}

} // namespace

int main(int argc, char** argv) {
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  bool together = false;
  try {
    Parameters parameters;
    ParameterHandler handler;
    ParameterAcceptor::declare_all_parameters(handler);
    if (argc > 1)
      handler.parse_input(argv[1]);
    ParameterAcceptor::parse_all_parameters(handler);
    together = run(parameters, MPI_COMM_WORLD);
    if (!together)
      std::cerr << "The image forces did not bring the unloaded shapes together.\n";
  } catch (const std::exception& error) { // prosup::Error is one; all ranks throw alike
    std::cerr << error.what() << '\n';
  }
  return together ? 0 : 1;
}
