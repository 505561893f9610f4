#ifndef PROSUP_FDM_FDM_UNLOADING_H
#define PROSUP_FDM_FDM_UNLOADING_H

#include <mpi.h>

#include <memory>
#include <string>

#include "prosup/core/log.h"
#include "prosup/fdm/fdm_body.h"
#include "prosup/fdm/fdm_parameters.h"
#include "prosup/fdm/vector_field.h"
#include "prosup/settling/effort.h"
#include "prosup/settling/settling_result.h"
#include "prosup/settling/simulation.h"

namespace prosup::fdm {

using settling::SettlingResult;

/// Finds the unloaded configuration of a body that was imaged under gravity, by the
/// finite differences of the paper (its eqs. 1 to 11 and Fig. 3). The points X of a
/// regular grid are in the unloaded configuration; the material at X is that of the
/// loaded image at X + w(X). A forward simulation predicts the displacement u(X), and
/// every n steps the map w is moved towards u. In the settled state w = u.
/// All functions are collective on the communicator.
class FdmUnloading {
public:
  /// A saved state: positions, velocities and forces, but not the material.
  using Snapshot = settling::Snapshot;

  /// Keeps a reference to the parameters, but not to the labels of the body.
  /// @throws Error if no voxel is tissue, nothing holds the body, or the grid has too
  /// many points.
  FdmUnloading(const FdmParameters& parameters, const FdmBody& body, MPI_Comm communicator,
               std::string name = "body", const Log& log = Log());
  ~FdmUnloading();

  /// Changes the stiffness of the tissues. The state is kept, so that the simulation
  /// continues from the present configuration.
  void set_material(const Material& material);

  /// Changes the stiffness of the springs on the chest, Pa/mm.
  void set_spring_stiffness(double stiffness);

  /// Adds a force density, given at the points X of grid(), which rises linearly from 0
  /// over the next `ramp_time` seconds. It is stored in the loaded configuration, at
  /// x = X + u(X), and resampled from there like the material.
  void add_force(const VectorField& increment, double ramp_time);

  /// Keeps w = 0 from now on: run() is then a plain forward simulation, and the labels
  /// are those of the unloaded configuration.
  void hold_reference();

  /// Simulates until the tolerances are met. Recovers from divergence and stalls (docs/fdm.md).
  /// @throws DivergenceError with a diagnosis if all retries are used up; the last good
  /// state is then restored.
  SettlingResult run(const settling::Effort& effort = {});
  /// Simulates `n_steps` steps. @throws as run().
  SettlingResult advance(unsigned n_steps);

  Snapshot save() const;
  void restore(const Snapshot& snapshot);

  /// The simulation grid, in the unloaded configuration.
  const image::VoxelGrid& grid() const;
  /// u on the simulation grid, on all ranks.
  VectorField displacement() const;
  double time_step() const;    ///< h_t, s
  double damping_rate() const; ///< r/rho, 1/s

private:
  class Simulation;
  std::unique_ptr<Simulation> simulation_;
};

} // namespace prosup::fdm

#endif
