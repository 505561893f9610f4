#ifndef TEXTURED_BLOCK_H
#define TEXTURED_BLOCK_H

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/grid/tria.h>
#include <prosup/image/voxel_image.h>
#include <prosup/mechanics/body/body.h>
#include <prosup/mesh/tet_mesh.h>

#include <memory>

/// The host's own parameters: a deal.II ParameterAcceptor like those of prosup.
/// Their sections stand side by side in one parameter file.
struct BlockParameters : dealii::ParameterAcceptor {
  BlockParameters();
  /// Declares in the handler it is given: ParameterAcceptor's own one is global.
  void declare_parameters(dealii::ParameterHandler& prm) override;

  double edge = 60.;                   ///< mm
  unsigned n_subdivisions = 7;         ///< along each edge
  double true_shear_modulus = 500.;    ///< Pa
  double assumed_shear_modulus = 700.; ///< Pa
  double poisson_ratio = 0.4;
};

/// A block of tetrahedra whose back (high y) has the boundary id 1.
void make_block(const BlockParameters& parameters, dealii::Triangulation<3>& block);

/// The same mesh over the ranks of a communicator.
std::unique_ptr<dealii::parallel::fullydistributed::Triangulation<3>>
distribute(dealii::Triangulation<3>& mesh, MPI_Comm communicator);

/// The whole mesh as prosup takes it back for its results.
prosup::mesh::TetMesh whole_mesh(const dealii::Triangulation<3>& mesh);

/// Moves the vertices of `mesh` to `positions`, which live on a body made of it.
void move_vertices(dealii::Triangulation<3>& mesh, const prosup::mechanics::Body& body,
                   const prosup::mechanics::NodeVector& positions);

/// What a scanner would see of a body whose material points X have moved to
/// `loaded`: a texture that is painted on the material, and 0 around it.
prosup::image::ScalarImage scan(const prosup::mechanics::Body& body,
                                const prosup::mechanics::NodeVector& loaded);

#endif
