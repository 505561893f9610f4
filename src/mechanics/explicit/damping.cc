#include "prosup/mechanics/explicit/damping.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace prosup::mechanics {

using namespace dealii;

const std::vector<std::string>& damping_names() {
  static const std::vector<std::string> names{"fixed", "lowest-frequency", "adaptive", "kinetic"};
  return names;
}

DampingControl::DampingControl(DampingScheme scheme, double first_rate, const Body& body)
    : scheme_(scheme), body_(body), first_rate_(first_rate),
      rate_(scheme == DampingScheme::kinetic ? 0. : first_rate) {
  body.initialize(last_displacement_);
  body.initialize(last_internal_force_);
}

void DampingControl::update(CentralDifferences& integrator, const NodeVector& displacement,
                            const NodeVector& external_force) {
  switch (scheme_) {
  case DampingScheme::fixed:
    break;
  case DampingScheme::lowest_frequency:
  case DampingScheme::adaptive:
    if (const double omega = frequency(integrator, displacement, external_force); omega > 0.)
      rate_ = frequency_factor_ * omega;
    break;
  case DampingScheme::kinetic:
    const double energy = integrator.report().kinetic_energy;
    const bool past_peak = energy < last_kinetic_energy_;
    if (past_peak)
      integrator.velocity() = 0.;
    last_kinetic_energy_ = past_peak ? 0. : energy;
    break;
  }
  integrator.set_damping(rate_);
}

bool DampingControl::mend_fixed_rate(CentralDifferences& integrator, const NodeVector& displacement,
                                     const NodeVector& external_force) {
  if (scheme_ != DampingScheme::fixed)
    return false;
  const double best = 2. * frequency(integrator, displacement, external_force);
  if (!(best > 3. * rate_ || best < rate_ / 3.))
    return false;
  scheme_ = DampingScheme::lowest_frequency;
  update(integrator, displacement, external_force);
  return true;
}

void DampingControl::store(NodeMemory& memory) const {
  memory.numbers["damping_scheme"] = static_cast<double>(scheme_);
  memory.numbers["damping_rate"] = rate_;
  memory.numbers["damping_frequency_factor"] = frequency_factor_;
  memory.numbers["last_kinetic_energy"] = last_kinetic_energy_;
  if (scheme_ == DampingScheme::adaptive) {
    memory.fields["last_displacement"] = last_displacement_;
    memory.fields["last_internal_force"] = last_internal_force_;
  }
}

void DampingControl::recall(const NodeMemory& memory, CentralDifferences& integrator) {
  scheme_ = static_cast<DampingScheme>(static_cast<int>(memory.number("damping_scheme")));
  rate_ = memory.number("damping_rate");
  frequency_factor_ = memory.number("damping_frequency_factor");
  last_kinetic_energy_ = memory.number("last_kinetic_energy");
  if (scheme_ == DampingScheme::adaptive) {
    last_displacement_ = memory.field("last_displacement");
    last_internal_force_ = memory.field("last_internal_force");
  }
  integrator.set_damping(rate_);
}

double DampingControl::frequency(const CentralDifferences& integrator,
                                 const NodeVector& displacement, const NodeVector& external_force) {
  double work = 0., inertia = 0.;
  for (unsigned i = 0; i < 3 * body_.n_owned_nodes(); ++i) {
    // The integrator leaves external minus internal force, zero at fixed nodes.
    const double internal = external_force.local_element(i) - integrator.force().local_element(i);
    double u = displacement.local_element(i), f = internal;
    if (scheme_ == DampingScheme::adaptive) {
      u -= last_displacement_.local_element(i);
      f -= last_internal_force_.local_element(i);
      last_displacement_.local_element(i) = displacement.local_element(i);
      last_internal_force_.local_element(i) = internal;
    }
    work += u * f;
    inertia += u * u * integrator.mass()[i / 3];
  }
  work = Utilities::MPI::sum(work, body_.communicator());
  inertia = Utilities::MPI::sum(inertia, body_.communicator());
  return work > 0. && inertia > 0. ? std::sqrt(work / inertia) : 0.;
}

} // namespace prosup::mechanics
