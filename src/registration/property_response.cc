#include "property_response.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

#include "prosup/mechanics/static/unloaded_response.h"
#include "prosup/registration/element_breast.h"

namespace prosup::registration {

using namespace dealii;
using mechanics::NodeVector;
using mechanics::UnloadedResponse;

namespace {

constexpr double least_jacobian = 0.1;    // after a step to balance
constexpr double small_difference = 1e-3; // of that of a trial
// Of linear equations. With derivatives to 0.01, results depend on the number of ranks by 0.06 mm,
// with 0.001 by 0.008 mm.
constexpr double derivative_tolerance = 1e-5, balance_tolerance = 1e-4;

/// dX/dq_i of one breast.
std::vector<NodeVector> derivatives_of(ElementBreast& breast, const UnloadedResponse& response,
                                       const MechanicalProperties& properties,
                                       const std::vector<const SearchedProperty*>& searched) {
  const NodeVector before = breast.unloading().out_of_balance();
  std::vector<NodeVector> derivatives;
  for (const SearchedProperty* property : searched) {
    MechanicalProperties moved = properties;
    const double q = property->get(properties),
                 difference = small_difference * property->difference;
    property->set(moved, q + difference);
    breast.set_properties(moved);
    NodeVector change = breast.unloading().out_of_balance();
    change -= before;
    change /= difference;
    derivatives.push_back(response.to(change, derivative_tolerance));
  }
  breast.set_properties(properties);
  return derivatives;
}

} // namespace

bool PropertyResponse::applies_to(const BreastPair& pair) {
  return pair.all([](Breast& breast) {
    ElementBreast* elements = breast.elements();
    return elements != nullptr && UnloadedResponse::applies_to(elements->supports());
  });
}

PropertyResponse::PropertyResponse(BreastPair& pair,
                                   const std::vector<const SearchedProperty*>& properties)
    : pair_(pair), largest_motion_(properties.size(), 0.) {
  pair.for_each([&](Position position, Breast& breast) {
    ElementBreast& elements = *breast.elements();
    responses_[position] = std::make_unique<UnloadedResponse>(
        elements.supports(), elements.material(), elements.unloading().body_force(),
        elements.unloading().unloaded());
  });
  balance();
  pair.for_each([&](Position position, Breast& breast) {
    ElementBreast& elements = *breast.elements();
    unloaded_[position] = elements.unloading().unloaded();
    derivatives_[position] =
        derivatives_of(elements, *responses_[position], pair.properties(), properties);
    for (unsigned i = 0; i < properties.size(); ++i)
      largest_motion_[i] = std::max(largest_motion_[i], derivatives_[position][i].linfty_norm());
  });
  for (double& motion : largest_motion_)
    motion = Utilities::MPI::max(motion, pair.ranks().world());
}

void PropertyResponse::balance() const {
  pair_.for_each([&](Position position, Breast& breast) {
    unloading::Unloading& unloading = breast.elements()->unloading();
    const UnloadedResponse& response = *responses_[position];
    const NodeVector before = unloading.unloaded(), force = unloading.out_of_balance();
    NodeVector moved = before;
    moved.add(1., response.to(force, balance_tolerance));
    const bool is_possible = unloading.move_to(moved) > least_jacobian;
    if (!is_possible ||
        !(response.imbalance(unloading.out_of_balance()) < response.imbalance(force)))
      unloading.move_to(before);
  });
}

double PropertyResponse::move(const std::vector<double>& change) const {
  double jacobian = std::numeric_limits<double>::max();
  pair_.for_each([&](Position position, Breast& breast) {
    NodeVector moved = unloaded_[position];
    for (unsigned i = 0; i < change.size(); ++i)
      moved.add(change[i], derivatives_[position][i]);
    jacobian = std::min(jacobian, breast.elements()->unloading().move_to(moved));
  });
  return Utilities::MPI::min(jacobian, pair_.ranks().world());
}

} // namespace prosup::registration
