#ifndef PROSUP_PIPELINE_FINITE_DIFFERENCES_H
#define PROSUP_PIPELINE_FINITE_DIFFERENCES_H

#include <memory>

#include "prosup/pipeline/registration_method.h"
#include "prosup/registration/simulated_grids.h"

namespace prosup::pipeline {

/// The breast on a grid, cut into tetrahedra, for evaluation and output.
mesh::UnloadedMesh mesh_of_grid(const Stages& stages, const fdm::VectorField& displacement,
                                const image::LabelImage& labels);

/// g of a direction, mm/s^2.
dealii::Tensor<1, 3> acceleration(const Stages& stages, const dealii::Tensor<1, 3>& direction);

/// How the case's tissue moves on the chest.
fdm::ChestContact chest_contact(const Stages& stages);

/// The paper's method: a grid in place of meshes, image forces accumulated in the running
/// simulation.
class FiniteDifferences : public RegistrationMethod {
public:
  FiniteDifferences(const Stages& stages, const registration::RankSplit& ranks, const Log& log)
      : stages_(stages), ranks_(ranks), log_(log) {}

  void build(Inputs& inputs) override;
  std::array<settling::SettlingResult, 2> unload() override { return grids_->unload(); }
  registration::MaterialUpdateResult
  update_material(const registration::Observer& observer) override;
  registration::ImageForceResult
  push_with_image_forces(const registration::Observer& observer) override;
  const registration::MechanicalProperties& properties() const override {
    return grids_->properties();
  }
  std::array<mesh::UnloadedMesh, 2> unloaded() const override;

private:
  const Stages& stages_;
  const registration::RankSplit& ranks_;
  const Log& log_;
  const Inputs* inputs_ = nullptr;
  std::unique_ptr<registration::SimulatedGrids> grids_;
};

} // namespace prosup::pipeline

#endif
