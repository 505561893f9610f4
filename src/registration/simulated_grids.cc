#include "prosup/registration/simulated_grids.h"

#include <deal.II/base/mpi.h>

#include <set>
#include <utility>

#include "compared_images.h"
#include "grid_similarity.h"
#include "prosup/core/collective.h"
#include "prosup/similarity/sum_of_squared_differences.h"

namespace prosup::registration {

using namespace dealii;
using settling::SettlingResult;
using similarity::prone;
using similarity::state_names;
using similarity::supine;

namespace {

constexpr std::array<State, 2> both{prone, supine};

std::vector<unsigned> tissue_labels(const image::LabelImage& labels, unsigned chest_label) {
  std::set<unsigned> found(labels.values.begin(), labels.values.end());
  found.erase(0);
  found.erase(chest_label);
  return {found.begin(), found.end()};
}

} // namespace

fdm::Material grid_material(const mechanics::TissueMaterial& material,
                            const mechanics::TissueStiffness& stiffness,
                            const image::LabelImage& labels, unsigned chest_label) {
  const std::vector<unsigned> tissues = tissue_labels(labels, chest_label);
  material.require_model("neo-hookean", "the finite-difference method");
  const mechanics::Material parameters = material.material_of(tissues, stiffness);
  fdm::Material result;
  for (std::size_t i = 0; i < tissues.size(); ++i) {
    const mechanics::LameParameters& lame = parameters[i];
    result.tissues[tissues[i]] = {lame.mu, lame.lambda};
  }
  return result;
}

/// Both displacements as they are now.
struct SimulatedGrids::Displaced {
  std::array<std::unique_ptr<const fdm::VectorField>, 2> fields;
  std::array<GridState, 2> states;
};

template <typename Work>
void SimulatedGrids::for_each(Work&& work) const {
  on_every_rank(ranks_.world(), [&] {
    for (const State state : both)
      if (ranks_.holds(state))
        work(state);
  });
}

SimulatedGrids::SimulatedGrids(const RankSplit& ranks, const GridSetup& setup,
                               const similarity::Scene& scene,
                               std::array<image::ScalarImage, 2> images,
                               const MechanicalProperties& properties)
    : ranks_(ranks), setup_(setup), scene_(scene), images_(std::move(images)),
      properties_(properties) {
  for_each([&](State state) {
    const fdm::FdmBody body{
        scene.labels[state],
        scene.chest_label,
        grid_material(setup_.material, properties.tissue, scene.labels[state], scene.chest_label),
        setup_.gravity[state],
        {setup_.contact, properties.chest_stiffness},
        setup_.density};
    unloading_[state] = std::make_unique<fdm::FdmUnloading>(
        setup_.parameters, body, ranks_.group(), state_names[state], Log(ranks_.group()));
  });
}

SimulatedGrids::~SimulatedGrids() = default;

bool SimulatedGrids::has_gland() const {
  // All ranks have the labels of both states.
  for (const image::LabelImage& labels : scene_.labels)
    if (setup_.material.has_gland(tissue_labels(labels, scene_.chest_label)))
      return true;
  return false;
}

void SimulatedGrids::set_properties(const MechanicalProperties& properties) {
  properties_ = properties;
  for_each([&](State state) {
    unloading_[state]->set_material(grid_material(setup_.material, properties.tissue,
                                                  scene_.labels[state], scene_.chest_label));
    unloading_[state]->set_spring_stiffness(properties.chest_stiffness);
  });
}

template <typename Run>
std::array<SettlingResult, 2> SimulatedGrids::run(Run&& run) {
  std::array<SettlingResult, 2> results;
  for_each([&](State state) {
    results[state] = run(*unloading_[state]);
    // The soft background may be squeezed, the tissue not.
    results[state].min_jacobian = smallest_tissue_jacobian(displacement(state), scene_, state);
  });
  return ranks_.share(std::move(results));
}

std::array<SettlingResult, 2> SimulatedGrids::unload(unsigned max_steps) {
  return run([&](fdm::FdmUnloading& unloading) { return unloading.run(max_steps); });
}

std::array<SettlingResult, 2> SimulatedGrids::advance(double duration) {
  return run([&](fdm::FdmUnloading& unloading) {
    return unloading.advance(steps_within(duration, unloading));
  });
}

void SimulatedGrids::save() {
  for_each([&](State state) { saved_[state] = unloading_[state]->save(); });
}

void SimulatedGrids::restore() {
  for_each([&](State state) { unloading_[state]->restore(saved_[state]); });
}

SimulatedGrids::Displaced SimulatedGrids::displaced() const {
  Displaced result;
  for_each([&](State state) {
    result.fields[state] = std::make_unique<fdm::VectorField>(displacement(state));
    result.states[state] = {result.fields[state].get(), &compared_images_[state]};
  });
  return result;
}

void SimulatedGrids::compare_on(double level, Compared compared) {
  const bool by_images = compared == Compared::images;
  const std::shared_ptr<const similarity::Metric> metric =
      by_images ? setup_.similarity.make_metric()
                : std::make_shared<similarity::SumOfSquaredDifferences>();
  metric_ = metric->name() + (by_images ? "" : " of tissues");
  for (const State state : both)
    if (ranks_.holds(state))
      compared_images_[state] = smoothed(
          by_images ? images_[state] : tissue_image(scene_.labels[state], scene_.gland_label),
          level);
  const Displaced present = displaced();
  similarity_ = std::make_unique<GridSimilarity>(ranks_, scene_, metric, present.states, level);
}

double SimulatedGrids::value() const {
  return similarity_->value(displaced().states);
}

std::vector<float> SimulatedGrids::residuals() const {
  return similarity_->residuals(displaced().states);
}

double SimulatedGrids::find_forces(similarity::Variable variable) {
  return similarity_->forces(displaced().states, variable, forces_);
}

void SimulatedGrids::add_forces(double weight, double momentum, double ramp) {
  for_each([&](State state) {
    fdm::VectorField& increment = increments_[state];
    if (increment.values.empty())
      increment = {forces_[state].grid, std::vector<Tensor<1, 3>>(forces_[state].values.size())};
    for (std::size_t i = 0; i < increment.values.size(); ++i)
      increment.values[i] = momentum * increment.values[i] + weight * forces_[state].values[i];
    unloading_[state]->add_force(increment, ramp / unloading_[state]->damping_rate());
  });
}

} // namespace prosup::registration
