#ifndef PROSUP_REGISTRATION_SIMULATED_BODIES_H
#define PROSUP_REGISTRATION_SIMULATED_BODIES_H

#include <optional>

#include "prosup/registration/body_pair.h"
#include "prosup/registration/similarity_setup.h"

namespace prosup::registration {

/// A pair of finite-element bodies. Keeps references to all it is given.
class SimulatedBodies : public SimulatedPair {
public:
  SimulatedBodies(BodyPair& pair, const SimilaritySetup& setup, const similarity::Scene& scene,
                  const mechanics::TissueMaterial& material)
      : pair_(pair), setup_(setup), scene_(scene), material_(material) {}

  bool has_gland() const override { return pair_.has_gland(material_); }
  const MechanicalProperties& properties() const override { return pair_.properties(); }
  void set_properties(const MechanicalProperties& properties) override {
    pair_.set_properties(material_, properties);
  }

  std::array<settling::SettlingResult, 2> unload(unsigned max_steps = 0) override;
  std::array<settling::SettlingResult, 2> advance(double duration) override;
  void save() override { saved_ = pair_.save(); }
  void restore() override { pair_.restore(saved_); }

  void compare_on(double level, Compared compared) override;
  std::string metric() const override { return comparison_->metric; }
  double value() const override;
  std::vector<float> residuals() const override;

  double find_forces(similarity::Variable variable) override;
  void add_forces(double weight, double momentum, double ramp) override;
  void forget_momentum() override { increments_ = {}; }

private:
  BodyPair& pair_;
  const SimilaritySetup& setup_;
  const similarity::Scene& scene_;
  const mechanics::TissueMaterial& material_;
  BodyPair::Snapshot saved_;
  std::optional<Comparison> comparison_;
  std::array<mechanics::NodeVector, 2> forces_, increments_;
};

} // namespace prosup::registration

#endif
