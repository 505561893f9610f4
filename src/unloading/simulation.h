#ifndef PROSUP_SRC_UNLOADING_SIMULATION_H
#define PROSUP_SRC_UNLOADING_SIMULATION_H

#include <string>
#include <vector>

#include "collapse_watch.h"
#include "prosup/mechanics/explicit/central_differences.h"
#include "prosup/mechanics/explicit/critical_step.h"
#include "prosup/mechanics/explicit/damping.h"
#include "prosup/settling/settling.h"
#include "prosup/unloading/unloading.h"

namespace prosup::unloading {

/// The physics of an unloading by finite elements: loads, time steps, the correction of
/// X, masses and snapshots.
class Unloading::Simulation final : public settling::Simulation {
public:
  Simulation(const UnloadingParameters& parameters, mechanics::Supports& supports,
             const dealii::Tensor<1, 3>& gravity_direction, const std::string& name,
             const Log& log);

  void set_material(const mechanics::Material& material);
  void add_force(const NodeVector& increment, double ramp_time);
  double move_to(const NodeVector& unloaded);
  double adopt(const NodeVector& unloaded);
  NodeVector out_of_balance();
  dealii::Tensor<1, 3> body_force() const { return parameters_.density * gravity_; }
  void set_gravity_direction(const dealii::Tensor<1, 3>& direction);
  void hold_reference() { holds_reference_ = true; }
  Snapshot save() const;
  void restore(const Snapshot& snapshot);

  mechanics::NodeMemory memory() const;
  void recall(const mechanics::NodeMemory& memory);

  const std::vector<std::string>& remarks() const { return remarks_; }
  const Snapshot& state() const { return state_; } ///< but for the velocity
  settling::Settling& loop() { return loop_; }

  settling::Report advance(unsigned n_steps, double gravity_ramp) override;
  void correct(double part) override;
  void update_time_step(double safety) override;
  double time_step() const override { return integrator_.time_step(); }
  double damping_rate() const override { return damping_.time_scale(); }
  double largest_displacement() const override;
  bool holds_reference() const override { return holds_reference_; }
  bool has_gravity() const override { return parameters_.gravity > 0.; }
  settling::Snapshot take_snapshot() const override;
  void restore(const settling::Snapshot& snapshot) override;
  void stop() override;
  void load_between(double from, double to) override;
  settling::Remedy mend(settling::Trouble trouble, bool gives_up_early) override;
  void strengthen_damping() override { damping_.strengthen(); }
  std::string worst_cell() override;
  std::string softness() const override;
  std::string advice() const override;

private:
  void check() const;
  void update_reference();
  void update_external_force();
  NodeVector displacement_to_mesh() const;
  double subtract_inner_forces(const NodeVector& displacement, NodeVector& force);
  settling::Remedy hold_stalled_nodes();
  settling::Remedy hold_chest();
  void hold(const std::vector<bool>& nodes);
  settling::Report report() const;
  double max_distance() const;

  const UnloadingParameters& parameters_;
  mechanics::Supports& supports_;
  const mechanics::Body& body_;
  dealii::Tensor<1, 3> gravity_; // acceleration
  const std::string name_;
  mechanics::InternalForce internal_force_;
  mechanics::HighestFrequency highest_frequency_;
  mechanics::CentralDifferences integrator_;
  mechanics::DampingControl damping_;
  CollapseWatch collapse_watch_;
  Snapshot state_;
  NodeVector external_force_;
  std::vector<double> nodal_volume_;
  bool holds_reference_ = false;
  bool is_fully_loaded_ = false;
  double gravity_from_ = 0., gravity_to_ = 1.; // fractions between which it rises
  double largest_head_ = 0.;                   // |g| times the extent along it, mm^2/s^2
  double mean_shear_modulus_ = 0.;             // Pa
  double free_fall_energy_ = 0.;               // of the body through its own height
  double weight_norm_ = 0.;
  std::vector<bool> held_;  // nodes that did not settle, once there are some
  unsigned n_troubles_ = 0; // before it has ever settled
  bool holds_chest_ = false;
  std::vector<std::string> remarks_; // about them
  double reference_volume_ = 1.;     // of the smallest cell of all ranks
  settling::Settling loop_;
};

} // namespace prosup::unloading

#endif
