#include "chest_motion.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace prosup::fdm {

using namespace dealii;

namespace {

Tensor<1, 3> at(const Dynamics::Vectors& vectors, std::size_t node) {
  return Tensor<1, 3>({vectors[0][node], vectors[1][node], vectors[2][node]});
}

} // namespace

ChestMotion::ChestMotion(const Slab& slab, const image::LabelImage& labels, unsigned chest_label,
                         const LoadedMaps& maps, const ChestCondition& condition,
                         const FdmParameters& parameters, double density)
    : slab_(slab), contact_(condition.contact), method_(parameters.contact_method()),
      correction_part_(parameters.correction_part), speed_limit_(parameters.speed_limit),
      mass_per_area_(density * parameters.spacing),
      wall_distance_(slab.n_nodes(), std::numeric_limits<float>::max()),
      slave_of_(slab.n_nodes(), -1) {
  const bool slides = condition.contact != ChestContact::fixed;
  const bool has_chest =
      std::find(labels.values.begin(), labels.values.end(), chest_label) != labels.values.end();
  if (has_chest)
    distance_ = SmoothDistance(labels, chest_label, maps.low(), maps.high(), parameters.spacing);
  unsigned long n_here = 0;
  for (std::size_t node = 0; has_chest && node < slab.n_nodes(); ++node) {
    const Point<3> position = slab.position(node);
    Tensor<1, 3> normal;
    const double depth = distance_.value(position, normal);
    const bool is_owned = node >= slab.owned_begin() && node < slab.owned_end();
    if (!slides)
      wall_distance_[node] = float(depth);
    // One layer, also where the surface is halfway between two.
    const double half = 0.5 * parameters.spacing;
    const bool is_slave =
        slides && is_owned && depth > -half && depth <= half && !slab.on_border(node);
    if (is_slave) {
      slave_of_[node] = int(slaves_.size());
      slaves_.push_back({node, position, depth});
    }
    n_here += is_slave || (!slides && is_owned && depth <= 0. ? 1 : 0);
  }
  n_nodes_ = Utilities::MPI::sum(n_here, slab.communicator());
  set_spring_stiffness(condition.spring_stiffness);
}

void ChestMotion::set_spring_stiffness(double stiffness) {
  spring_per_mass_ = stiffness / mass_per_area_;
}

Tensor<1, 3> ChestMotion::spring(const Tensor<1, 3>& displacement,
                                 const Tensor<1, 3>& normal) const {
  return -spring_per_mass_ * (displacement - (displacement * normal) * normal);
}

void ChestMotion::correct(Dynamics& dynamics) const {
  const double h_t = dynamics.time_step();
  const double steepness = 10. * std::log(9.) / speed_limit_;
  for (const Slave& slave : slaves_) {
    const Tensor<1, 3> u = at(dynamics.displacement, slave.node);
    Tensor<1, 3> du = at(dynamics.increment, slave.node), normal;
    distance_.value(slave.position + u, normal);
    if (spring_per_mass_ > 0.)
      du += h_t * h_t / dynamics.friction() * spring(u, normal);
    // Pushed back along the normal from where it comes, a node that rests stays at rest.
    Tensor<1, 3> next_normal;
    const double gap = slave.distance - distance_.value(slave.position + u + du, next_normal);
    if (contact_ == ChestContact::sliding || gap > 0.) {
      double s = 1.;
      if (method_ == ContactMethod::gradual) {
        const double approach = (gap > 0. ? 1. : -1.) * (du * normal) / h_t;
        s = correction_part_ /
            (1. + std::exp(std::min(500., steepness * (approach - speed_limit_))));
      }
      du += s * gap * normal;
    }
    for (unsigned c = 0; c < 3; ++c)
      dynamics.increment[c][slave.node] = Real(du[c]);
  }
}

void ChestMotion::project(const Dynamics& dynamics, std::size_t node,
                          Tensor<1, 3>& acceleration) const {
  if (slave_of_[node] < 0)
    return;
  const Slave& slave = slaves_[slave_of_[node]];
  const Tensor<1, 3> u = at(dynamics.displacement, node);
  Tensor<1, 3> normal;
  distance_.value(slave.position + u, normal);
  if (spring_per_mass_ > 0.)
    acceleration += spring(u, normal);
  const double across = acceleration * normal;
  if (contact_ == ChestContact::sliding || across < 0.)
    acceleration -= across * normal;
}

} // namespace prosup::fdm
