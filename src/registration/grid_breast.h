#ifndef PROSUP_SRC_REGISTRATION_GRID_BREAST_H
#define PROSUP_SRC_REGISTRATION_GRID_BREAST_H

#include <memory>
#include <optional>

#include "grid_samples.h"
#include "prosup/fdm/fdm_unloading.h"
#include "prosup/registration/breast_model.h"

namespace prosup::registration {

/// A breast on the grid of the finite-difference method of the paper.
class GridBreast : public Breast {
public:
  /// Keeps references to the model and the scene. Collective on `communicator`.
  GridBreast(const BreastModel& model, const BreastInput& input, MPI_Comm communicator);

  bool has_gland() const override;
  void set_properties(const MechanicalProperties& properties) override;

  settling::SettlingResult unload(const settling::Effort& effort = {}) override;
  settling::SettlingResult load() override;
  settling::SettlingResult advance(double duration) override;
  void save() override;
  void restore() override;

  similarity::Box unloaded_box() const override;
  bool samples_surroundings() const override { return true; }
  const similarity::Samples& sample(const similarity::SimilarityDomain& domain,
                                    const image::ScalarImage& image) override;
  void set_image_forces(const std::vector<float>& slope, similarity::Variable variable) override;
  void add_image_forces(double weight, double momentum, double ramp) override;
  void forget_momentum() override { increment_.clear(); }

  /// The grid cut into tetrahedra.
  mesh::UnloadedMesh mesh() const override;

private:
  fdm::Material material(const mechanics::TissueStiffness& stiffness) const;
  /// Puts the smallest J of the tissue in place of that of the grid: the soft background may be
  /// squeezed, the tissue not.
  settling::SettlingResult of_tissue(settling::SettlingResult result) const;
  const image::LabelImage& labels() const { return scene_.labels[position_]; }

  const Position position_;
  const similarity::Scene& scene_;
  const BreastModel& model_;
  MPI_Comm communicator_;
  std::unique_ptr<fdm::FdmUnloading> unloading_;
  fdm::FdmUnloading::Snapshot saved_;
  std::optional<GridSamples> samples_;
  fdm::VectorField image_forces_; ///< densities, [S]/mm^4
  std::vector<dealii::Tensor<1, 3>> increment_;
};

} // namespace prosup::registration

#endif
