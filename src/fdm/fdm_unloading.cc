#include "prosup/fdm/fdm_unloading.h"

#include <utility>

#include "simulation.h"

namespace prosup::fdm {

FdmUnloading::FdmUnloading(const FdmParameters& parameters, const FdmBody& body,
                           MPI_Comm communicator, std::string name, const Log& log)
    : simulation_(std::make_unique<Simulation>(parameters, body, communicator, name, log)) {}

FdmUnloading::~FdmUnloading() = default;

void FdmUnloading::set_material(const Material& material) {
  simulation_->set_material(material);
}

void FdmUnloading::set_spring_stiffness(double stiffness) {
  simulation_->set_spring_stiffness(stiffness);
}

void FdmUnloading::add_force(const VectorField& increment, double ramp_time) {
  simulation_->add_force(increment, ramp_time);
}

void FdmUnloading::hold_reference() {
  simulation_->hold_reference();
}

SettlingResult FdmUnloading::run(const settling::Effort& effort) {
  return simulation_->loop().run(effort);
}

SettlingResult FdmUnloading::advance(unsigned n_steps) {
  return simulation_->loop().advance(n_steps);
}

FdmUnloading::Snapshot FdmUnloading::save() const {
  return simulation_->take_snapshot();
}

void FdmUnloading::restore(const Snapshot& snapshot) {
  simulation_->restore(snapshot);
  simulation_->update_time_step(simulation_->loop().caution().step_safety);
}

const image::VoxelGrid& FdmUnloading::grid() const {
  return simulation_->grid();
}

VectorField FdmUnloading::displacement() const {
  return simulation_->displacement();
}

double FdmUnloading::time_step() const {
  return simulation_->time_step();
}

double FdmUnloading::damping_rate() const {
  return simulation_->damping_rate();
}

} // namespace prosup::fdm
