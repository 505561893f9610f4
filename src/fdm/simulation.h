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
#include "slab.h"
#include "wall.h"

namespace prosup::fdm {

/// What has to be kept to return to a state.
struct State {
  Dynamics::Vectors displacement, increment;
  Dynamics::Vectors pull_back; ///< w, mm
  double time_step = 0.;       ///< of the increments, s
  double time = 0.;            ///< s
  double loading = 0.;         ///< part of gravity that acts, all from 1 on
};

struct FdmUnloading::Snapshot {
  State state;
  ForceRecord force_record;
};

/// What is known after some steps, of all ranks.
struct Report {
  double min_jacobian = 0.;
  double residual = 0.;         ///< out-of-balance force over weight
  double distance = 0.;         ///< max |w - u| in the tissue, mm
  double max_displacement = 0.; ///< in the tissue, mm
  double kinetic_energy = 0.;   ///< of the tissue, over its weight times its height
};

class FdmUnloading::Simulation {
public:
  Simulation(const FdmParameters& parameters, const image::LabelImage& labels, unsigned chest_label,
             const Material& material, const Tensor<1, 3>& gravity, const ChestCondition& chest,
             MPI_Comm communicator, std::string name, const Log& log);

  void set_material(const Material& material);
  void set_spring_stiffness(double stiffness) { chest_.set_spring_stiffness(stiffness); }
  void add_force(const VectorField& force, double ramp_time);
  Snapshot snapshot() const { return {save(), force_record_}; }
  void restore(const Snapshot& snapshot);
  void hold_reference() { holds_reference_ = true; }
  UnloadingResult simulate(unsigned max_steps, bool until_settled);

  const Slab& slab() const { return slab_; }
  const Dynamics& dynamics() const { return dynamics_; }
  double damping_rate() const { return damping_; }
  unsigned max_steps() const { return parameters_.max_steps; }
  VectorField displacement() const;

private:
  /// Values that a return makes safer.
  struct Caution {
    double lag_factor, step_safety, gravity_ramp, background_stiffness; ///< as in the parameters
    double damping_factor; ///< automatic r/rho over the lowest frequency
  };

  Report steps(unsigned n);
  Report report(const Dynamics::Vectors& before, double min_jacobian);
  void follow();
  void resample();
  void update_force();
  void update_time_step();
  std::string trouble(const Report& report) const;
  void retreat(const std::string& trouble, UnloadingResult& result);
  bool stiffen_background(); ///< false if it is stiff enough already
  void strengthen();
  State save() const;
  void restore(const State& state);

  const FdmParameters& parameters_;
  const std::string name_;
  const Log log_;
  const Tensor<1, 3> gravity_;
  double density_;
  Material material_;
  LoadedMaps maps_;
  ForceRecord force_record_;
  Slab slab_;
  Dynamics dynamics_;
  ChestMotion chest_;
  std::unique_ptr<Wall> wall_;
  std::vector<bool> is_near_mobile_; ///< nodes whose material is felt
  Dynamics::Vectors pull_back_;
  NodalField tissue_;
  Dynamics::Vectors extra_force_; ///< force density over density, mm/s^2
  double time_ = 0., loading_ = 0.;
  double damping_ = 0., first_damping_ = 0.; ///< 1/s
  bool fully_loaded_ = false, holds_reference_ = false;
  double head_ = 0.; ///< |g| times the extent of the image along it, mm^2/s^2
  Caution caution_;
  State first_, last_good_;
  double last_good_error_ = 0.;
  bool has_kept_ = false;
};

} // namespace prosup::fdm

#endif
