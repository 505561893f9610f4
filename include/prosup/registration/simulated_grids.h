#ifndef PROSUP_REGISTRATION_SIMULATED_GRIDS_H
#define PROSUP_REGISTRATION_SIMULATED_GRIDS_H

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "prosup/core/log.h"
#include "prosup/fdm/fdm_unloading.h"
#include "prosup/registration/body_pair.h"
#include "prosup/registration/similarity_setup.h"

namespace prosup::registration {

class GridSimilarity;

/// The stiffness of the tissues that `labels` has besides air (0) and chest.
fdm::Material grid_material(const mechanics::TissueMaterial& material,
                            const mechanics::TissueStiffness& stiffness,
                            const image::LabelImage& labels, unsigned chest_label);

/// What finite differences have to be told of a case.
struct GridSetup {
  const fdm::FdmParameters& parameters;
  const mechanics::TissueMaterial& material;
  const similarity::SimilarityParameters& similarity;
  std::array<dealii::Tensor<1, 3>, 2> gravity; ///< acceleration, mm/s^2
  fdm::ChestContact contact = fdm::ChestContact::fixed;
  double density = tissue_density; ///< g/mm^3
};

/// A pair of breasts on the grids of the finite-difference method.
class SimulatedGrids : public SimulatedPair {
public:
  /// Keeps references to ranks, scene and what `setup` refers to. `images` are scaled to
  /// [0, 1], of the held states.
  SimulatedGrids(const RankSplit& ranks, const GridSetup& setup, const similarity::Scene& scene,
                 std::array<image::ScalarImage, 2> images, const MechanicalProperties& properties);
  ~SimulatedGrids() override;

  /// u on the grid of a held state. Collective on its ranks.
  fdm::VectorField displacement(State state) const { return unloading_[state]->displacement(); }

  bool has_gland() const override;
  const MechanicalProperties& properties() const override { return properties_; }
  void set_properties(const MechanicalProperties& properties) override;

  std::array<settling::SettlingResult, 2> unload(unsigned max_steps = 0) override;
  std::array<settling::SettlingResult, 2> advance(double duration) override;
  void save() override;
  void restore() override;

  void compare_on(double level, Compared compared) override;
  std::string metric() const override { return metric_; }
  double value() const override;
  std::vector<float> residuals() const override;

  double find_forces(similarity::Variable variable) override;
  void add_forces(double weight, double momentum, double ramp) override;
  void forget_momentum() override { increments_ = {}; }

private:
  struct Displaced;

  template <typename Work>
  void for_each(Work&& work) const;
  template <typename Run>
  std::array<settling::SettlingResult, 2> run(Run&& run);
  Displaced displaced() const;

  const RankSplit& ranks_;
  const GridSetup setup_;
  const similarity::Scene& scene_;
  const std::array<image::ScalarImage, 2> images_;
  MechanicalProperties properties_;
  std::array<std::unique_ptr<fdm::FdmUnloading>, 2> unloading_; // of the held states
  std::array<fdm::FdmUnloading::Snapshot, 2> saved_;
  std::string metric_;
  std::unique_ptr<GridSimilarity> similarity_;
  std::array<image::ScalarImage, 2> compared_images_;
  std::array<fdm::VectorField, 2> forces_, increments_;
};

} // namespace prosup::registration

#endif
