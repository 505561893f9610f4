#include "simulation.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "prosup/core/error.h"

namespace prosup::fdm {

using namespace dealii;

namespace {

constexpr double largest_grid = 2e8; // points

// Corrections between two updates of the time step.
constexpr unsigned update_interval = 10;

/// The labels of the material that are in the image.
std::vector<unsigned> tissues_of(const FdmBody& body, const std::string& name) {
  const auto& values = body.labels.values;
  std::vector<unsigned> labels;
  for (const auto& tissue : body.material.tissues) {
    const unsigned label = tissue.first;
    if (label > 255 || label == body.chest_label)
      throw Error(format("The tissue label %u of %s is the chest label or above 255; give tissues "
                         "other labels.",
                         label, name.c_str()));
    if (std::find(values.begin(), values.end(), label) != values.end())
      labels.push_back(label);
  }
  if (labels.empty())
    throw Error("No voxel of " + name +
                " has the label of a tissue; check the labels and those of the material.");
  return labels;
}

image::VoxelGrid simulation_grid(const LoadedMaps& maps, const FdmParameters& parameters) {
  double n = 1.;
  for (unsigned d = 0; d < 3; ++d)
    n *= (maps.high()[d] - maps.low()[d] + 2. * parameters.padding) / parameters.spacing + 3.;
  if (!(n < largest_grid))
    throw Error(format("The simulation grid would have %.1e points, more than %.0e; choose a "
                       "larger 'FDM/Spacing' than %g mm or less 'FDM/Padding' than %g mm.",
                       n, largest_grid, parameters.spacing, parameters.padding));
  return image::grid_around(maps.low(), maps.high(), parameters.spacing,
                            std::max(parameters.padding, parameters.spacing));
}

/// A damping rate to begin with, 1/s: the critical one of a layer in shear that is as thick
/// as the image is wide.
double first_damping(const Material& material, double density, double extent) {
  double mu = std::numeric_limits<double>::max();
  for (const auto& tissue : material.tissues)
    mu = std::min(mu, tissue.second.mu);
  return numbers::PI * std::sqrt(mu / density) / extent;
}

/// Whether tissue touches a face of the image.
bool touches(const LoadedMaps& maps) {
  bool any = false;
  for (const auto& sides : maps.touched_faces())
    any = any || sides[0] || sides[1];
  return any;
}

/// Distance of each node from the nearest wall, mm: the chest, if tissue is fixed to it,
/// and with `has_faces` the faces of the image that tissue touches.
std::vector<float> wall_distances(const Slab& slab, const ChestMotion& chest,
                                  const LoadedMaps& maps, bool has_faces) {
  std::vector<float> result(slab.n_nodes());
  for (std::size_t node = 0; node < slab.n_nodes(); ++node) {
    const Point<3> X = slab.position(node);
    double distance = chest.wall_distance(node);
    for (unsigned d = 0; d < 3 && has_faces; ++d) {
      if (maps.touched_faces()[d][0])
        distance = std::min(distance, X[d] - maps.low()[d]);
      if (maps.touched_faces()[d][1])
        distance = std::min(distance, maps.high()[d] - X[d]);
    }
    result[node] = float(distance);
  }
  return result;
}

void check(const Material& material) {
  for (const auto& [label, lame] : material.tissues)
    if (!(lame.mu > 0.) || !(lame.lambda > 0.))
      throw Error(format("The tissue with label %u has mu = %g Pa and lambda = %g Pa; both have to "
                         "be positive.",
                         label, lame.mu, lame.lambda));
}

} // namespace

FdmUnloading::Simulation::Simulation(const FdmParameters& parameters, const FdmBody& body,
                                     MPI_Comm communicator, const std::string& name, const Log& log)
    : parameters_(parameters), name_(name), gravity_(body.gravity), density_(body.density),
      maps_(body.labels, tissues_of(body, name), body.chest_label,
            parameters.map_spacing * parameters.spacing, body.chest.contact != ChestContact::fixed),
      slab_(simulation_grid(maps_, parameters), communicator), dynamics_(slab_, body.density),
      chest_(slab_, body.labels, body.chest_label, maps_, body.chest, parameters, body.density),
      background_stiffness_(parameters.background_stiffness),
      loop_(*this, parameters, {name, "FDM", "a cell", "max |w-u|", update_interval}, log) {
  choose_mobile_nodes(body.chest, body.chest_label);
  double extent = 0.;
  for (unsigned d = 0; d < 3; ++d) {
    head_ += std::abs(gravity_[d]) * (maps_.high()[d] - maps_.low()[d]);
    extent = std::max(extent, maps_.high()[d] - maps_.low()[d]);
  }
  first_damping_ = first_damping(body.material, body.density, extent);
  damping_ =
      parameters.damping_rate > 0. ? parameters.damping_rate : damping_factor_ * first_damping_;
  tissue_.assign(slab_.n_nodes(), Real(0));
  for (unsigned c = 0; c < 3; ++c)
    pull_back_[c] = extra_force_[c] = tissue_;
  set_material(body.material);
}

void FdmUnloading::Simulation::choose_mobile_nodes(const ChestCondition& chest,
                                                   unsigned chest_label) {
  const bool is_held_by_chest = chest.contact == ChestContact::fixed && chest_.n_nodes() > 0;
  const Border border = parameters_.border_scheme();
  const bool has_faces =
      border == Border::fixed || (border == Border::automatic && !is_held_by_chest);
  wall_ = std::make_unique<Wall>(slab_, wall_distances(slab_, chest_, maps_, has_faces));
  std::vector<bool> moves(slab_.n_nodes(), false);
  for (std::size_t node = slab_.owned_begin(); node < slab_.owned_end(); ++node)
    moves[node] = !slab_.on_border(node) && !wall_->leads(node);
  if (chest_.n_nodes() == 0 && !(has_faces && touches(maps_)))
    throw Error("Nothing holds " + name_ +
                format(": no voxel has the chest label %u and no tissue is held at the border of "
                       "the image; check the labels, or set 'FDM/Border' to fixed.",
                       chest_label));
  dynamics_.set_mobile(moves);

  // A node is felt by its six neighbours; those of other ranks are near enough.
  is_near_mobile_.assign(slab_.n_nodes(), false);
  const std::size_t strides[3] = {1, slab_.row(), slab_.plane()};
  for (std::size_t node = slab_.owned_begin(); node < slab_.owned_end(); ++node)
    if (moves[node]) {
      is_near_mobile_[node] = true;
      for (const std::size_t stride : strides)
        is_near_mobile_[node - stride] = is_near_mobile_[node + stride] = true;
    }
}

void FdmUnloading::Simulation::set_material(const Material& material) {
  check(material);
  material_ = material;
  maps_.set_material(material_, background_stiffness_);
  force_record_.update(time_, maps_);
  resample();
  update_time_step(loop_.caution().step_safety);
}

void FdmUnloading::Simulation::add_force(const VectorField& increment, double ramp_time) {
  force_record_.add(increment, displacement(), time_, ramp_time, maps_);
}

} // namespace prosup::fdm
