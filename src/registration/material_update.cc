#include "prosup/registration/material_update.h"

#include <optional>

#include "prosup/core/error.h"

namespace prosup::registration {

using namespace dealii;

namespace {

/// One walk through shear moduli, and the best state seen.
class Search {
public:
  Search(BodyPair& pair, const SimilaritySetup& setup, const similarity::SimilarityDomain& domain,
         double level, const mechanics::TissueMaterial& material, double shear_modulus,
         const Log& log)
      : pair_(pair), setup_(setup), domain_(domain), level_(level), material_(material), log_(log),
        images_(setup.images(pair, level)), best_value_(similarity()), best_(pair.save()) {
    result_.shear_modulus = shear_modulus;
    record(shear_modulus, best_value_);
  }

  /// Multiplies by `factor` while the similarity improves; returns how often it did.
  unsigned walk(double factor, unsigned max_steps) {
    unsigned n_accepted = 0;
    while (n_accepted < max_steps && improves(result_.shear_modulus * factor))
      ++n_accepted;
    pair_.set_material(material_, result_.shear_modulus);
    pair_.restore(best_);
    return n_accepted;
  }

  MaterialUpdateResult result() const { return result_; }

private:
  bool improves(double shear_modulus) {
    try {
      pair_.set_material(material_, shear_modulus);
      const auto unloaded = pair_.unload();
      result_.n_steps += unloaded[0].n_steps + unloaded[1].n_steps;
      const double value = similarity();
      record(shear_modulus, value);
      if (!(value < best_value_))
        return false;
      best_value_ = value;
      best_ = pair_.save();
      result_.shear_modulus = shear_modulus;
      result_.converged = unloaded[0].converged && unloaded[1].converged;
      return true;
    } catch (const Error& error) {
      log_.line(std::string("  shear modulus rejected: ") + error.what());
      return false;
    }
  }

  double similarity() const {
    return setup_.force().evaluate(domain_, pair_.loaded_states(images_)).value;
  }

  void record(double shear_modulus, double value) {
    const auto iteration = static_cast<unsigned>(result_.history.size());
    result_.history.push_back({"material", level_, iteration, shear_modulus, 0., value});
    log_.line(format("  material: mu %.1f Pa, SSD %.1f", shear_modulus, value));
  }

  BodyPair& pair_;
  const SimilaritySetup& setup_;
  const similarity::SimilarityDomain& domain_;
  const double level_;
  const mechanics::TissueMaterial& material_;
  const Log& log_;
  const std::array<image::ScalarImage, 2> images_;
  double best_value_;
  BodyPair::Snapshot best_;
  MaterialUpdateResult result_;
};

} // namespace

MaterialUpdate::MaterialUpdate() : ParameterAcceptor("Material update") {}

void MaterialUpdate::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter(
      "Factor", factor_,
      "Factor on the shear modulus of one step, used both ways (paper: 1.1 clinical, 1.2 "
      "phantom). Units: none.",
      Patterns::Double(1.0001, 10.));
  prm.add_parameter("Maximum steps", max_steps_,
                    "Largest number of accepted steps; 0 keeps the initial material. Units: none.",
                    Patterns::Integer(0, 1000));
  prm.add_parameter("Level", level_,
                    "Edge of the voxels on which the images are compared. Units: mm.",
                    Patterns::Double(0.1, 50.));
}

MaterialUpdateResult MaterialUpdate::run(BodyPair& pair, const SimilaritySetup& setup,
                                         const similarity::SimilarityDomain& domain,
                                         const mechanics::TissueMaterial& material,
                                         double shear_modulus, const Log& log) const {
  Search search(pair, setup, domain, level_, material, shear_modulus, log);
  if (max_steps_ > 0 && search.walk(factor_, max_steps_) == 0)
    search.walk(1. / factor_, max_steps_);
  return search.result();
}

} // namespace prosup::registration
