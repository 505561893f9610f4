#ifndef PROSUP_REGISTRATION_PROPERTY_SEARCH_H
#define PROSUP_REGISTRATION_PROPERTY_SEARCH_H

#include <string>
#include <vector>

#include "property_trials.h"

namespace prosup::registration {

/// The properties that can be searched for, by name.
const std::vector<std::string>& property_names();

/// MaterialUpdate's search on one level, for some of property_names(), of which
/// those are left out that the scene does not have. Derivatives are brought up to date
/// along the steps and found anew where these gain too little; unless the search is to
/// go to the end, it stops there. The level goes on where `progress` has derivatives; `keep` is
/// called before each step.
void search_properties(const std::vector<std::string>& names, PropertyTrials& trials,
                       MaterialProgress& progress, unsigned max_steps, double least_gain,
                       bool to_the_end, const Keeper& keep);

/// Names of the searched properties that are at an end of their range where no tissue should be.
std::vector<std::string> properties_at_bound(const std::vector<std::string>& names,
                                             const MechanicalProperties& properties,
                                             const PropertiesOfPair& pair);

} // namespace prosup::registration

#endif
