#ifndef PROSUP_SRC_REGISTRATION_PROPERTY_RESPONSE_H
#define PROSUP_SRC_REGISTRATION_PROPERTY_RESPONSE_H

#include <memory>
#include <vector>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/static/unloaded_response.h"
#include "prosup/registration/breast_pair.h"
#include "searched_property.h"

namespace prosup::registration {

/// How the unloaded positions X of both breasts of a pair follow properties q, in the present state
/// and for its present properties. From F(X; q) = 0 (mechanics::UnloadedResponse) follows
///   dX/dq = (-dF/dX)^-1 dF/dq,
/// with dF/dq by differences at fixed X. All functions are collective on the world of the ranks.
class PropertyResponse {
public:
  /// Whether both breasts have it.
  static bool applies_to(const BreastPair& pair);

  /// @throws Error if the equations of one breast cannot be solved.
  PropertyResponse(BreastPair& pair, const std::vector<const SearchedProperty*>& properties);

  /// Brings both breasts, unloaded with properties near these, closer to balance: a step of
  /// Newton's method with the matrix of the state in which this was made. Slow motions in which
  /// explicit dynamics are taken for settled end here. A step that would crush elements, or
  /// that leads away from balance, is not taken.
  void balance() const;

  /// Largest distance by which a node moves for a unit of this property, mm.
  double largest_motion(unsigned property) const { return largest_motion_[property]; }

  /// Moves both breasts to X + sum_i change_i dX/dq_i. Returns the smallest J of both; if it is not
  /// positive, they cannot be simulated there.
  double move(const std::vector<double>& change) const;

private:
  BreastPair& pair_;
  PerPosition<std::unique_ptr<mechanics::UnloadedResponse>> responses_;
  PerPosition<mechanics::NodeVector> unloaded_;                 // X
  PerPosition<std::vector<mechanics::NodeVector>> derivatives_; // dX/dq_i
  std::vector<double> largest_motion_;
};

} // namespace prosup::registration

#endif
