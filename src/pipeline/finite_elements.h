#ifndef PROSUP_PIPELINE_FINITE_ELEMENTS_H
#define PROSUP_PIPELINE_FINITE_ELEMENTS_H

#include "prosup/pipeline/body_building.h"
#include "prosup/pipeline/registration_method.h"

namespace prosup::pipeline {

/// Meshes of the masks, explicit dynamics on them.
class FiniteElements : public RegistrationMethod {
public:
  FiniteElements(const Stages& stages, const registration::RankSplit& ranks, const Log& log)
      : stages_(stages), log_(log), pair_(ranks), similarity_(stages.similarity, ranks.world()) {}

  void build(Inputs& inputs) override;
  std::array<settling::SettlingResult, 2> unload() override;
  registration::MaterialUpdateResult
  update_material(const registration::Observer& observer) override;
  registration::ImageForceResult
  push_with_image_forces(const registration::Observer& observer) override;
  const registration::MechanicalProperties& properties() const override {
    return pair_.properties();
  }
  std::array<mesh::UnloadedMesh, 2> unloaded() const override {
    return gather_unloaded(meshes_, pair_);
  }

private:
  const Stages& stages_;
  const Log& log_;
  registration::BodyPair pair_;
  const registration::SimilaritySetup similarity_;
  const similarity::Scene* scene_ = nullptr;
  MeshPair meshes_;
};

} // namespace prosup::pipeline

#endif
