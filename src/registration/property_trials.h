#ifndef PROSUP_REGISTRATION_PROPERTY_TRIALS_H
#define PROSUP_REGISTRATION_PROPERTY_TRIALS_H

#include <optional>
#include <string>
#include <vector>

#include "property_response.h"
#include "prosup/registration/material_update.h"

namespace prosup::registration {

/// What of a pair decides which properties it has.
struct PropertiesOfPair {
  bool has_gland;
  bool can_tilt;             ///< its gravity
  bool consists_of_elements; ///< not of voxels

  explicit PropertiesOfPair(const BreastPair& pair);
};

/// Unloads a pair with other mechanical properties, starting from the best state so far, and
/// compares its breasts on one level.
class PropertyTrials {
public:
  /// Begins the level, or goes on with it where `progress` has its grid. Residuals further apart
  /// than `correlation_length` (mm) are taken for independent.
  PropertyTrials(BreastPair& pair, Comparison comparison, double correlation_length, const Log& log,
                 const Observer& observer, MaterialProgress& progress);

  double best_value() const { return progress_.best_value; }
  const MechanicalProperties& best() const { return best_properties_; }
  const PropertiesOfPair& pair() const { return has_; }
  /// The weight of MaterialUpdate's prior, beside the dissimilarity, of which `left` is error.
  double prior_weight(double left) const;

  /// Brings the best state, which is the present one, closer to balance, and finds derivatives of
  /// its residuals by these properties from those of the unloaded positions. The trials from this
  /// state then start where they lead. Nothing if they cannot be found, now or further on.
  struct Linearization {
    std::vector<float> residuals;
    std::vector<std::vector<float>> derivatives;
  };
  std::optional<Linearization> linearize(const std::vector<const SearchedProperty*>& searched);
  /// Whether it finds some.
  bool can_derive() const { return can_derive_; }

  /// Unloads with these properties; false if no state was found.
  bool unload(const MechanicalProperties& properties);
  double value() const { return comparison_.value(); }
  std::vector<float> residuals() const { return comparison_.residuals(); }
  /// Makes the present state the best one.
  void accept(double value);
  void return_to_best();

private:
  std::string in_words(const MechanicalProperties& properties) const;
  void report(double value) const;
  std::vector<float> derivative(unsigned property, const std::vector<float>& before) const;
  void move_towards(const MechanicalProperties& properties) const;
  double pair_volume() const; // mm^3

  BreastPair& pair_;
  const Comparison comparison_;
  const Log& log_;
  const Observer& observer_;
  MaterialProgress& progress_;
  const PropertiesOfPair has_;
  bool can_derive_;
  bool converged_ = true;
  MechanicalProperties best_properties_;
  std::vector<const SearchedProperty*> searched_;
  std::optional<PropertyResponse> response_; // of the best state by them
};

} // namespace prosup::registration

#endif
