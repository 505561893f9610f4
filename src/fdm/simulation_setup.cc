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

/// The tissues of a material that suits the labels.
std::vector<unsigned> tissues_of(const Material& material, const image::LabelImage& image,
                                 unsigned chest_label, const std::string& name) {
  std::vector<unsigned> labels;
  for (const auto& tissue : material.tissues) {
    const unsigned label = tissue.first;
    if (label > 255 || label == chest_label)
      throw Error(format("The tissue label %u of %s is the chest label or above 255; give tissues "
                         "other labels.",
                         label, name.c_str()));
    if (std::find(image.values.begin(), image.values.end(), label) != image.values.end())
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

/// r/rho until there is an estimate: critical for the shear of a layer as thick
/// as the image is along gravity.
double first_damping(const Material& material, double extent) {
  double mu = std::numeric_limits<double>::max();
  for (const auto& tissue : material.tissues)
    mu = std::min(mu, tissue.second.mu);
  return numbers::PI * std::sqrt(mu / material.density) / extent;
}

/// Whether tissue is at a face of the image.
bool touches(const LoadedMaps& maps) {
  bool any = false;
  for (const auto& sides : maps.touched_faces())
    any = any || sides[0] || sides[1];
  return any;
}

/// Of each node from the nearest of the chest, where it is a wall, and the faces of the
/// image that tissue touches, if `has_faces`, mm.
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

} // namespace

FdmUnloading::Simulation::Simulation(const FdmParameters& parameters,
                                     const image::LabelImage& labels, unsigned chest_label,
                                     const Material& material, const Tensor<1, 3>& gravity,
                                     const ChestCondition& chest, MPI_Comm communicator,
                                     std::string name, const Log& log)
    : parameters_(parameters), name_(std::move(name)), log_(log), gravity_(gravity),
      density_(material.density),
      maps_(labels, tissues_of(material, labels, chest_label, name_), chest_label,
            parameters.map_spacing * parameters.spacing, chest.contact != ChestContact::fixed),
      slab_(simulation_grid(maps_, parameters), communicator), dynamics_(slab_, material.density),
      chest_(slab_, labels, chest_label, maps_, chest, parameters, material.density),
      caution_{parameters.lag_factor, parameters.step_safety, parameters.gravity_ramp,
               parameters.background_stiffness, 2.} {
  const bool is_held_by_chest = chest.contact == ChestContact::fixed && chest_.n_nodes() > 0;
  const Border border = parameters.border_scheme();
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

  double extent = 0.;
  for (unsigned d = 0; d < 3; ++d) {
    head_ += std::abs(gravity[d]) * (maps_.high()[d] - maps_.low()[d]);
    extent = std::max(extent, maps_.high()[d] - maps_.low()[d]);
  }
  first_damping_ = first_damping(material, extent);
  damping_ = parameters.damping > 0. ? parameters.damping : 2. * first_damping_;
  tissue_.assign(slab_.n_nodes(), Real(0));
  for (unsigned c = 0; c < 3; ++c)
    pull_back_[c] = extra_force_[c] = tissue_;
  set_material(material);
}

} // namespace prosup::fdm
