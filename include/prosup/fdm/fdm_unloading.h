#ifndef PROSUP_FDM_FDM_UNLOADING_H
#define PROSUP_FDM_FDM_UNLOADING_H

#include <mpi.h>

#include <memory>
#include <string>

#include "prosup/core/log.h"
#include "prosup/fdm/chest_condition.h"
#include "prosup/fdm/fdm_parameters.h"
#include "prosup/fdm/material.h"
#include "prosup/fdm/vector_field.h"

namespace prosup::fdm {

/// How far an unloading has come.
struct UnloadingResult {
  bool converged = false;
  unsigned n_steps = 0;     ///< in this call
  unsigned n_retries = 0;   ///< returns to a good state, and strengthened damping, in this call
  double residual = 0.;     ///< out-of-balance force over weight
  double distance = 0.;     ///< max |w - u| in the tissue, mm
  double min_jacobian = 0.; ///< smallest J = det dx/dX, of background too
  std::string explanation;  ///< why run() stopped without having settled; else empty
};

/// Finds the unloaded configuration of a body imaged under gravity by the finite
/// differences of the paper (its eqs. 1 to 11 and Fig. 3). The material of each
/// point X of a regular grid in the unloaded configuration is that of the loaded
/// image at X + w(X). A forward simulation predicts the displacement u(X), and
/// every n steps the map w follows it (FdmParameters). Where it settles w = u.
/// Collective on the communicator.
class FdmUnloading {
public:
  /// `labels` may be given up after construction, `parameters` not. Labels that are
  /// neither `chest_label` nor in `material` are air. `gravity` is the acceleration,
  /// mm/s^2 (LPS).
  /// @throws Error if no tissue is labelled, nothing holds the body, or the grid
  /// has too many points.
  FdmUnloading(const FdmParameters& parameters, const image::LabelImage& labels,
               unsigned chest_label, const Material& material, const dealii::Tensor<1, 3>& gravity,
               const ChestCondition& chest, MPI_Comm communicator, std::string name = "body",
               const Log& log = Log());
  ~FdmUnloading();

  /// Changes the stiffness of the tissues and continues from the present state.
  void set_material(const Material& material);

  /// Changes the springs on the chest, Pa/mm.
  void set_spring_stiffness(double stiffness);

  /// Adds a force density, given at points X of grid(), that rises linearly from 0
  /// to its value over `ramp_time` seconds from now. It is kept in the loaded
  /// configuration, at x = X + u(X), from where it is resampled as the material is.
  void add_force(const VectorField& force, double ramp_time);

  /// Keeps w = 0 from now on: a plain forward simulation of the labels, which are
  /// then those of the unloaded configuration.
  void hold_reference();

  /// Simulates until settled to the tolerances. Where it diverges it goes back to a
  /// good state and continues with stiffer air or a longer lag, a smaller step and a slower ramp.
  /// @throws DivergenceError when all retries are used up; the last good state is
  /// restored first.
  UnloadingResult run();
  /// The same, at most `max_steps` steps.
  UnloadingResult run(unsigned max_steps);
  /// Simulates `n_steps` steps. @throws as run().
  UnloadingResult advance(unsigned n_steps);

  /// What has to be kept to return to a state: positions, velocities and forces, not the
  /// material.
  struct Snapshot;
  std::shared_ptr<const Snapshot> save() const;
  void restore(const Snapshot& snapshot);

  /// The simulation grid, in the unloaded configuration.
  const image::VoxelGrid& grid() const;
  /// u on the simulation grid, on all ranks.
  VectorField displacement() const;
  double time_step() const;    ///< s
  double damping_rate() const; ///< r/rho, 1/s

private:
  class Simulation;
  std::unique_ptr<Simulation> simulation_;
};

} // namespace prosup::fdm

#endif
