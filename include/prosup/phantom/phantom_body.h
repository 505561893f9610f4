#ifndef PROSUP_PHANTOM_PHANTOM_BODY_H
#define PROSUP_PHANTOM_PHANTOM_BODY_H

#include <memory>

#include "prosup/mechanics/static/quasi_static.h"
#include "prosup/mesh/tet_mesh.h"
#include "prosup/phantom/anatomy.h"
#include "prosup/phantom/phantom_parameters.h"

namespace prosup::phantom {

/// What acts on the phantom in one position.
struct Load {
  dealii::Tensor<1, 3> body_force; ///< rho g, g/(mm^2 s^2)
  double push_pressure = 0.;       ///< on the left side, Pa
};

/// The phantom under a load. The mesh has the linear cells between the nodes of the quadratic
/// ones, in which the true displacement is interpolated. It is on rank 0, and empty elsewhere.
struct LoadedPhantom {
  mesh::UnloadedMesh mesh;
  mechanics::QuasiStaticResult result;
};

/// The phantom as a body of quadratic tetrahedra. Nodes on the skin and the chest lie exactly
/// in these surfaces. Collective on its communicator.
class PhantomBody {
public:
  /// Keeps references to both.
  PhantomBody(const MechanicsParameters& parameters, const Anatomy& anatomy, MPI_Comm communicator);

  const mechanics::Body& body() const { return *body_; }

  /// Equilibrium under a load. @throws DivergenceError if none is found.
  LoadedPhantom load(const Load& load, const mechanics::QuasiStaticParameters& solver,
                     const Log& log) const;

private:
  void put_on_surfaces();
  mechanics::Material material() const;
  mechanics::NodeVector push(double pressure) const;

  const MechanicsParameters& parameters_;
  const Geometry& geometry_;
  mesh::TetMesh mesh_; // refined, on rank 0
  std::unique_ptr<mechanics::Body> body_;
  mechanics::NodeVector unloaded_;
};

} // namespace prosup::phantom

#endif
