#ifndef PROSUP_SETTLING_SIMULATION_H
#define PROSUP_SETTLING_SIMULATION_H

#include <memory>
#include <string>

namespace prosup::settling {

/// An element or cell with J = det dx/dX at or below this value has collapsed.
constexpr double smallest_healthy_jacobian = 0.02;

/// The state of a simulation after a block of steps; the same on all ranks.
struct Report {
  double residual = 0.;         ///< norm of the out-of-balance forces over that of the weight
  double distance = 0.;         ///< largest error of the unloaded positions, mm
  double min_jacobian = 0.;     ///< smallest J in any step of the block
  double kinetic_energy = 0.;   ///< over that of a free fall through the body's own height
  bool is_fully_loaded = false; ///< all loads had their full value
  bool has_inverted_reference = false; ///< an element of the unloaded configuration is inverted
};

/// A saved state. Only the simulation that saved it knows what is in it.
using Snapshot = std::shared_ptr<const void>;

enum class Trouble {
  divergence, ///< the state is unphysical, or about to be
  stall       ///< the state is healthy, but its error no longer falls
};

/// What a simulation changed to cure a trouble.
struct Remedy {
  std::string description;    ///< "stiffer air"; empty if it changed nothing
  bool is_sufficient = false; ///< longer lag, more damping and tighter tolerances are not needed
  bool starts_anew = false;   ///< what was simulated so far is of no use
};

/// What Settling has to know of a simulation, mostly for its messages.
struct Description {
  std::string name;         ///< of the body, "prone"
  std::string section;      ///< of the parameters, "Unloading"
  std::string element;      ///< what collapses, "an element"
  std::string distance;     ///< symbol of the distance in the report, "max |x-u-X|"
  unsigned update_interval; ///< corrections between two updates of the time step
};

/// A damped explicit simulation under gravity that also corrects its unloaded
/// configuration. It holds the physics; Settling decides what to do when. If the
/// simulation runs on several ranks, all functions are collective.
class Simulation {
public:
  virtual ~Simulation() = default;

  /// Simulates `n_steps` time steps with the present unloaded configuration. The
  /// loads increase at the start of the block; gravity rises linearly over
  /// `gravity_ramp` damping times, at once if that is 0.
  virtual Report advance(unsigned n_steps, double gravity_ramp) = 0;
  /// Corrects the unloaded configuration by a part, at most 1, of the prediction.
  virtual void correct(double part) = 0;
  /// Sets the time step to `safety` times the present critical one.
  virtual void update_time_step(double safety) = 0;

  virtual double time_step() const = 0;    ///< s
  virtual double damping_rate() const = 0; ///< r/rho, 1/s
  /// Largest displacement after the last block, mm.
  virtual double largest_displacement() const = 0;
  /// Whether the unloaded configuration is given, so that it is never corrected.
  virtual bool holds_reference() const = 0;
  /// Whether there is a load that could be reduced.
  virtual bool has_gravity() const = 0;

  /// The state, and back to it.
  virtual Snapshot take_snapshot() const = 0;
  virtual void restore(const Snapshot& snapshot) = 0;
  /// Sets all velocities to zero.
  virtual void stop() = 0;
  /// Starts the ramp of gravity anew, from one fraction of it to another.
  virtual void load_between(double from, double to) = 0;

  /// Changes what causes the trouble, if the simulation can tell, but only what is small where the
  /// caller `gives_up_early`. Called before it goes back to a good state.
  virtual Remedy mend(Trouble trouble, bool gives_up_early) = 0;
  /// Damps higher modes better from now on, even if the body settles more slowly.
  virtual void strengthen_damping() = 0;

  /// "cell 7 near (1.0, 2.0, 3.0) mm with J = 0.01": where the last block went
  /// wrong; empty if that is unknown.
  virtual std::string worst_cell() = 0;
  /// "rho g L/mu = 3.2": weight of a column of the body's height over its stiffness.
  virtual std::string softness() const = 0;
  /// "raise 'Material/Shear modulus'": what would help a body that has not settled.
  virtual std::string advice() const {
    return "raise 'Material/Shear modulus' or check the mask and mesh there";
  }
};

} // namespace prosup::settling

#endif
