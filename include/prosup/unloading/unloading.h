#ifndef PROSUP_UNLOADING_UNLOADING_H
#define PROSUP_UNLOADING_UNLOADING_H

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "prosup/core/log.h"
#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/body/node_memory.h"
#include "prosup/mechanics/body/supports.h"
#include "prosup/mechanics/element/internal_force.h"
#include "prosup/settling/effort.h"
#include "prosup/settling/settling_result.h"
#include "prosup/unloading/unloading_parameters.h"

namespace prosup::unloading {

using mechanics::NodeVector;
using settling::SettlingResult;

/// Finds the unloaded configuration X of a body that was imaged under gravity, by
/// the prediction-correction of the paper (its Fig. 3) in Lagrangian form. The loaded
/// position x of each node is known. A forward simulation from the present X predicts
/// the displacement u, and every n steps of length h
///   X <- X + beta (x - u - X),  beta = min(1, n h/tau), tau = lag factor/(r/rho),
/// or beta = 1 with the full correction of the paper (docs/unloading.md). A settled
/// simulation fulfils
///   internal(X -> x) = gravity + added force + supports,  X + u = x.
/// Nodes that slide are put back on their surface in both configurations.
/// All functions are collective on the communicator of the body.
class Unloading {
public:
  /// A saved state: everything but the material.
  struct Snapshot {
    NodeVector unloaded, displacement, velocity, force, force_increment;
    double time = 0., ramp_start = 0., ramp_time = 0.; ///< s
    double loading = 0.; ///< time over the gravity ramp; all of gravity acts from 1 on
  };

  /// `gravity_direction` is a vector in LPS of any positive length. Keeps references
  /// to parameters and supports.
  /// @throws Error if nothing holds the body, the direction is zero or the damping
  /// rate is not positive.
  Unloading(const UnloadingParameters& parameters, mechanics::Supports& supports,
            const dealii::Tensor<1, 3>& gravity_direction, std::string name = "body",
            const Log& log = Log());
  ~Unloading();

  /// Sets the material as InternalForce::set_material does. The state is kept, so that
  /// the simulation continues from the present configuration. Has to be called before
  /// the first step.
  void set_material(const mechanics::Material& material);

  /// Turns gravity into the direction of this vector in LPS, of any positive length. The state is
  /// kept. @throws Error if the vector is zero.
  void set_gravity_direction(const dealii::Tensor<1, 3>& direction);

  /// Adds nodal forces (owned nodes, g mm/s^2; for example the image forces of eq. 15),
  /// which rise linearly from 0 over the next `ramp_time` seconds.
  void add_force(const NodeVector& increment, double ramp_time);

  /// Sets X to `unloaded` (owned nodes, mm) and u to x - X, after projecting sliding
  /// nodes onto their surfaces, and stops all motion. Returns the smallest J = det dx/dX; if that
  /// is not positive, the state cannot be simulated.
  double move_to(const NodeVector& unloaded);
  /// The same, with the forces added so far replaced by those that hold this state in balance.
  double adopt(const NodeVector& unloaded);

  /// external(X) - internal(X -> x) - springs(X -> x) with the present loads, material and supports
  /// (owned nodes, g mm/s^2), for the loaded positions x of the mesh.
  NodeVector out_of_balance();
  /// rho g, g/(mm^2 s^2).
  dealii::Tensor<1, 3> body_force() const;

  /// Keeps X fixed from now on: run() is then a plain forward simulation, which settles
  /// in the loaded state X + u.
  void hold_reference();

  /// As settling::Settling::set_observer.
  void set_observer(std::function<bool(unsigned n_steps)> observer);

  /// As settling::Settling::set_keeper.
  void set_keeper(std::function<void(unsigned n_steps)> keeper);

  /// Simulates until the tolerances are met. Recovers from divergence and stalls
  /// (docs/stability.md).
  /// @throws DivergenceError with a diagnosis if all retries are used up; the last good
  /// state is then restored.
  SettlingResult run(const settling::Effort& effort = {});
  /// Simulates `n_steps` steps. @throws as run().
  SettlingResult advance(unsigned n_steps);

  /// X, mm, with ghosts.
  const NodeVector& unloaded() const;
  /// u of the forward simulation, mm, with ghosts.
  const NodeVector& displacement() const;
  double time_step() const; ///< h, s
  /// r/rho, 1/s; the initial rate if the damping scheme has none.
  double damping_rate() const;

  /// Sentences on what was done to let the body settle.
  const std::vector<std::string>& remarks() const;

  Snapshot save() const;
  void restore(const Snapshot& snapshot);

  /// Everything but the material: what the simulation goes on from in another process, where its
  /// next steps are the same as here.
  mechanics::NodeMemory memory() const;
  /// Goes on from there, with the material as it is. @throws Error if something is missing.
  void recall(const mechanics::NodeMemory& memory);

private:
  class Simulation;
  std::unique_ptr<Simulation> simulation_;
};

} // namespace prosup::unloading

#endif
