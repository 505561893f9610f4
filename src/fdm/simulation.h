#ifndef PROSUP_SRC_FDM_SIMULATION_H
#define PROSUP_SRC_FDM_SIMULATION_H

#include <memory>
#include <string>
#include <vector>

#include "chest_motion.h"
#include "dynamics.h"
#include "force_record.h"
#include "loaded_maps.h"
#include "prosup/fdm/fdm_unloading.h"
#include "prosup/settling/settling.h"
#include "slab.h"
#include "wall.h"

namespace prosup::fdm {

/// The physics of an unloading by finite differences: loads, resampling, time steps, the
/// correction of the map w and snapshots.
class FdmUnloading::Simulation final : public settling::Simulation {
public:
  Simulation(const FdmParameters& parameters, const FdmBody& body, MPI_Comm communicator,
             const std::string& name, const Log& log);

  void set_material(const Material& material);
  void set_spring_stiffness(double stiffness) { chest_.set_spring_stiffness(stiffness); }
  void add_force(const VectorField& increment, double ramp_time);
  void hold_reference() { holds_reference_ = true; }

  const image::VoxelGrid& grid() const { return slab_.grid(); }
  VectorField displacement() const;
  settling::Settling& loop() { return loop_; }

  settling::Report advance(unsigned n_steps, double gravity_ramp) override;
  void correct(double part) override;
  void update_time_step(double safety) override;
  double time_step() const override { return dynamics_.time_step(); }
  double damping_rate() const override { return damping_; }
  double largest_displacement() const override { return largest_displacement_; }
  bool holds_reference() const override { return holds_reference_; }
  bool has_gravity() const override { return gravity_.norm() > 0.; }
  Snapshot take_snapshot() const override;
  void restore(const Snapshot& snapshot) override;
  void stop() override;
  void load_between(double from, double to) override;
  settling::Remedy mend(settling::Trouble trouble, bool) override;
  void strengthen_damping() override;
  std::string worst_cell() override;
  std::string softness() const override;

private:
  struct State;
  enum Sum { residual, weight, work, inertia, kinetic, volume, n_sums };

  void choose_mobile_nodes(const ChestCondition& chest, unsigned chest_label);
  void resample();
  void update_force();
  settling::Report report(const Dynamics::Vectors& before);
  void add_to_sums(std::size_t node, const Dynamics::Vectors& before, double* sums,
                   double& distance, double& displacement) const;
  void follow_lowest_frequency(double work_sum, double inertia_sum);

  const FdmParameters& parameters_;
  const std::string name_;
  const Tensor<1, 3> gravity_; ///< acceleration, mm/s^2
  const double density_;
  Material material_;
  LoadedMaps maps_;
  ForceRecord force_record_;
  Slab slab_;
  Dynamics dynamics_;
  ChestMotion chest_;
  std::unique_ptr<Wall> wall_;
  std::vector<bool> is_near_mobile_; ///< nodes whose material is felt
  Dynamics::Vectors pull_back_;      ///< w, mm
  NodalField tissue_;                ///< part of the volume
  Dynamics::Vectors extra_force_;    ///< force density over density, mm/s^2
  double time_ = 0., loading_ = 0.;
  double gravity_from_ = 0., gravity_to_ = 1.; ///< fractions between which it rises
  double damping_ = 0., first_damping_ = 0.;   ///< 1/s
  double damping_factor_ = 2.;                 ///< automatic r/rho over the lowest frequency
  double background_stiffness_;                ///< over that of the softest tissue
  double min_jacobian_ = 1.;                   ///< in the last block, of this rank
  double largest_displacement_ = 0.;           ///< in the tissue, mm
  bool is_fully_loaded_ = false, holds_reference_ = false;
  double head_ = 0.; ///< |g| times the extent of the image along it, mm^2/s^2
  settling::Settling loop_;
};

} // namespace prosup::fdm

#endif
