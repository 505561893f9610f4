#ifndef PROSUP_PIPELINE_BODY_BUILDING_H
#define PROSUP_PIPELINE_BODY_BUILDING_H

#include <array>
#include <memory>
#include <string>

#include "prosup/core/log.h"
#include "prosup/mesh/tet_mesh.h"
#include "prosup/pipeline/inputs.h"
#include "prosup/pipeline/stages.h"
#include "prosup/registration/body_pair.h"

namespace prosup::pipeline {

/// Meshes of both states, whole, on rank 0 of all ranks; in the coordinates of the
/// original images.
using MeshPair = std::array<mesh::TetMesh, 2>;

/// Sets up a body of the chosen elements from a mesh on rank 0, which becomes
/// that of Body::cells(): with quadratic elements its refinement. Collective.
std::unique_ptr<mechanics::Body> make_body(const Stages& stages, mesh::TetMesh& mesh,
                                           MPI_Comm communicator);

/// Meshes both masks, each on the first rank of its group, distributes the
/// meshes, and sets up bodies and unloadings of `pair`. The images in `inputs`
/// move into the pair. Collective.
MeshPair build_bodies(const Stages& stages, Inputs& inputs, registration::BodyPair& pair,
                      const Log& log);

/// The meshes of both states with their present unloaded positions, on rank 0;
/// empty elsewhere. Collective.
std::array<mesh::UnloadedMesh, 2> gather_unloaded(const MeshPair& meshes,
                                                  const registration::BodyPair& pair);

/// Copies an unloaded mesh from one rank to another; only these two call it.
void transfer_unloaded(mesh::UnloadedMesh& mesh, int from, int to, MPI_Comm communicator);

/// One line on how far the unloading of `name` has come.
std::string describe(const std::string& name, const settling::SettlingResult& result);
std::string describe(const std::string& name, const mechanics::QuasiStaticResult& result);

/// rho g of a state (0 prone, 1 supine), g/(mm^2 s^2).
dealii::Tensor<1, 3> body_force(const Stages& stages, unsigned state);

} // namespace prosup::pipeline

#endif
