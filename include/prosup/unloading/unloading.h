#ifndef PROSUP_UNLOADING_UNLOADING_H
#define PROSUP_UNLOADING_UNLOADING_H

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "prosup/core/log.h"
#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/body/supports.h"
#include "prosup/mechanics/element/internal_force.h"
#include "prosup/mechanics/explicit/central_differences.h"
#include "prosup/mechanics/explicit/damping.h"
#include "prosup/unloading/unloading_parameters.h"

namespace prosup::unloading {

using mechanics::NodeVector;

/// How far an unloading has come.
struct UnloadingResult {
  bool converged = false;
  unsigned n_steps = 0;     ///< in this call
  unsigned n_retries = 0;   ///< returns to the last good state, in this call
  double residual = 0.;     ///< out-of-balance force over weight
  double distance = 0.;     ///< max |x - u - X|, mm
  double min_jacobian = 0.; ///< smallest J = det dx/dX
  std::string explanation;  ///< why run() stopped without having settled; else empty

  template <typename Archive>
  void serialize(Archive& archive, unsigned) {
    archive& converged& n_steps& n_retries& residual& distance& min_jacobian& explanation;
  }
};

class DivergenceGuard;

/// Finds the unloaded configuration X of a body imaged under gravity by the
/// prediction-correction of the paper (its Fig. 3) in Lagrangian form. The
/// loaded position x of each node is known. A forward simulation on the
/// current X predicts the displacement u, and every n steps
///   X <- X + beta (x - u - X),  beta = min(1, n h/tau), tau = lag factor/(r/rho),
/// or beta = 1 with the full correction of the paper (docs/unloading.md).
/// Where it settles, internal(X -> x) = gravity + extra force + supports, and
/// X + u = x. Nodes that slide on a surface are put back to it in both
/// configurations.
/// Collective on the communicator of the body.
class Unloading {
public:
  /// What has to be kept to return to a state.
  struct State {
    NodeVector unloaded, displacement, velocity, force, force_increment;
    double time = 0., ramp_start = 0., ramp_time = 0.; ///< s
    double loading = 0.;                               ///< part of gravity that acts, all from 1 on
  };

  /// `gravity_direction` is a direction in LPS of any positive length.
  /// Keeps references to parameters and supports. @throws Error if nothing holds
  /// the body.
  Unloading(const UnloadingParameters& parameters, mechanics::Supports& supports,
            const dealii::Tensor<1, 3>& gravity_direction, std::string name = "body",
            const Log& log = Log());
  ~Unloading();

  /// As InternalForce::set_material. Keeps the state: a changed material
  /// continues from the present configuration.
  void set_material(const mechanics::Material& material);

  /// Adds nodal forces (owned nodes, g mm/s^2; image forces, eq. 15) that rise
  /// linearly from 0 to their value over `ramp_time` seconds from now.
  void add_force(const NodeVector& increment, double ramp_time);

  /// Takes `unloaded` (owned nodes, mm) as X and x - X as u, with the nodal forces
  /// that hold this state in place of those added before. X is put on the surfaces of the
  /// supports first. Returns the smallest J = det dx/dX; if that is not positive,
  /// the state cannot be simulated. Collective.
  double adopt(const NodeVector& unloaded);

  /// Keeps X where it is from now on: a plain forward simulation of the body
  /// under gravity, in which run() settles the loaded state X + u.
  void hold_reference() { holds_reference_ = true; }

  /// Looks at each healthy state, every n steps, with the number of steps of the
  /// present call; the simulation stops where it returns false. Has to return
  /// the same on all ranks.
  using Observer = std::function<bool(unsigned n_steps)>;
  void set_observer(Observer observer) { observer_ = std::move(observer); }

  /// Simulates until settled to the tolerances. Where it diverges or gets no
  /// nearer it goes back to a good state and continues with a longer lag, a smaller
  /// step and a slower ramp.
  /// @throws DivergenceError with a diagnosis when all retries are used up; the
  /// last good state is restored first. A body that has never settled is then
  /// searched for the part of gravity under which it does, in a few short runs.
  UnloadingResult run();

  /// Simulates `n_steps` steps. @throws as run().
  UnloadingResult advance(unsigned n_steps);

  const mechanics::Body& body() const { return body_; }
  const mechanics::Supports& supports() const { return supports_; }
  /// X, mm, with ghosts.
  const NodeVector& unloaded() const { return state_.unloaded; }
  /// u of the forward simulation, mm, with ghosts.
  const NodeVector& displacement() const { return state_.displacement; }
  /// Largest distance of a node that slides from its surface, mm. Collective.
  double largest_gap() const {
    return supports_.contacts().largest_gap(unloaded(), displacement());
  }
  double time_step() const { return integrator_.time_step(); }
  /// r/rho, 1/s; without damping that of the first steps.
  double damping_rate() const { return damping_.time_scale(); }
  const std::string& name() const { return name_; }

  State save() const { return state_with_velocity(); }
  void restore(const State& state);

private:
  UnloadingResult simulate(unsigned max_steps, bool until_settled);
  void correct_unloaded_positions();
  void update_reference();
  void update_mass();
  void update_external_force();
  double max_distance() const;
  double largest_displacement() const;
  bool recover_from_stall(double error, UnloadingResult& result);
  void retreat(const std::string& trouble, bool is_stalled, UnloadingResult& result);
  void end_unsettled(UnloadingResult& result);
  [[noreturn]] void give_up(const std::string& what);
  std::string search_load();
  bool settles();
  State state_with_velocity() const;

  const UnloadingParameters& parameters_;
  mechanics::Supports& supports_;
  const mechanics::Body& body_;
  const dealii::Tensor<1, 3> gravity_;
  const std::string name_;
  const Log log_;
  mechanics::InternalForce internal_force_;
  mechanics::HighestFrequency highest_frequency_;
  mechanics::CentralDifferences integrator_;
  mechanics::DampingControl damping_;
  Observer observer_;
  State state_;
  std::unique_ptr<DivergenceGuard> guard_;
  NodeVector external_force_;
  std::vector<double> nodal_volume_;
  bool holds_reference_ = false;
  bool fully_loaded_ = false; // all ramps were over in the last steps
  bool has_settled_ = false;
  double gravity_from_ = 0., gravity_to_ = 1.; // parts of it between which it rises
  double weight_norm_ = 0.;
  double min_jacobian_ = 1.;     // this rank's, since the last report
  double reference_volume_ = 1.; // smallest cell volume, all ranks
};

} // namespace prosup::unloading

#endif
