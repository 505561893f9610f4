#include "prosup/unloading/unloading.h"

#include <utility>

#include "simulation.h"

namespace prosup::unloading {

using namespace dealii;

Unloading::Unloading(const UnloadingParameters& parameters, mechanics::Supports& supports,
                     const dealii::Tensor<1, 3>& gravity_direction, std::string name,
                     const Log& log)
    : simulation_(
          std::make_unique<Simulation>(parameters, supports, gravity_direction, name, log)) {}

Unloading::~Unloading() = default;

void Unloading::set_material(const mechanics::Material& material) {
  simulation_->set_material(material);
}

void Unloading::set_gravity_direction(const dealii::Tensor<1, 3>& direction) {
  simulation_->set_gravity_direction(direction);
}

void Unloading::add_force(const NodeVector& increment, double ramp_time) {
  simulation_->add_force(increment, ramp_time);
}

double Unloading::move_to(const NodeVector& unloaded) {
  return simulation_->move_to(unloaded);
}

NodeVector Unloading::out_of_balance() {
  return simulation_->out_of_balance();
}

Tensor<1, 3> Unloading::body_force() const {
  return simulation_->body_force();
}

double Unloading::adopt(const NodeVector& unloaded) {
  return simulation_->adopt(unloaded);
}

void Unloading::hold_reference() {
  simulation_->hold_reference();
}

void Unloading::set_observer(std::function<bool(unsigned)> observer) {
  simulation_->loop().set_observer(std::move(observer));
}

void Unloading::set_keeper(std::function<void(unsigned)> keeper) {
  simulation_->loop().set_keeper(std::move(keeper));
}

SettlingResult Unloading::run(const settling::Effort& effort) {
  return simulation_->loop().run(effort);
}

SettlingResult Unloading::advance(unsigned n_steps) {
  return simulation_->loop().advance(n_steps);
}

const NodeVector& Unloading::unloaded() const {
  return simulation_->state().unloaded;
}

const NodeVector& Unloading::displacement() const {
  return simulation_->state().displacement;
}

double Unloading::time_step() const {
  return simulation_->time_step();
}

double Unloading::damping_rate() const {
  return simulation_->damping_rate();
}

const std::vector<std::string>& Unloading::remarks() const {
  return simulation_->remarks();
}

Unloading::Snapshot Unloading::save() const {
  return simulation_->save();
}

void Unloading::restore(const Snapshot& snapshot) {
  simulation_->restore(snapshot);
}

mechanics::NodeMemory Unloading::memory() const {
  return simulation_->memory();
}

void Unloading::recall(const mechanics::NodeMemory& memory) {
  simulation_->recall(memory);
}

} // namespace prosup::unloading
