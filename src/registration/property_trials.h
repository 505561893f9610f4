#ifndef PROSUP_REGISTRATION_PROPERTY_TRIALS_H
#define PROSUP_REGISTRATION_PROPERTY_TRIALS_H

#include <array>
#include <vector>

#include "prosup/registration/material_update.h"

namespace prosup::registration {

/// Unloads a pair with other mechanical properties, from the best state so far,
/// and compares its images on one level.
class PropertyTrials {
public:
  PropertyTrials(BodyPair& pair, Comparison comparison, const mechanics::TissueMaterial& material,
                 double level, const Log& log, const Observer& observer,
                 MaterialUpdateResult& result);

  double best_value() const { return best_value_; }
  const MechanicalProperties& best() const { return best_properties_; }

  /// Unloads with these properties; false if no state was found.
  bool unload(const MechanicalProperties& properties);
  /// Similarity of the present state.
  double value() const;
  /// Its residuals: the squares of these add up to twice the similarity of the SSD, and
  /// their derivatives to those of any metric.
  std::vector<float> residuals() const;
  /// Makes the present state the best one.
  void accept(double value);
  void return_to_best();

private:
  void report(double value) const;

  BodyPair& pair_;
  const Comparison comparison_;
  const mechanics::TissueMaterial& material_;
  const double level_;
  const Log& log_;
  const Observer& observer_;
  MaterialUpdateResult& result_;
  bool converged_ = true;
  unsigned n_accepted_ = 0;
  double best_value_;
  MechanicalProperties best_properties_;
  BodyPair::Snapshot best_;
};

} // namespace prosup::registration

#endif
