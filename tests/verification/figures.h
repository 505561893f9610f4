#ifndef PROSUP_TESTS_VERIFICATION_FIGURES_H
#define PROSUP_TESTS_VERIFICATION_FIGURES_H

#include <string>

#include "prosup/core/log.h"
#include "prosup/mechanics/body/element.h"
#include "prosup/mechanics/laws/law.h"

namespace prosup::tests {

/// The finite elements under test, in double precision.
constexpr mechanics::ElementType all_element_types[] = {mechanics::ElementType::linear,
                                                        mechanics::ElementType::nodal_pressure,
                                                        mechanics::ElementType::quadratic};

inline std::string name_of(mechanics::ElementType type) {
  return mechanics::element_names()[static_cast<unsigned>(type)];
}

/// ", <law>" for laws other than the default.
inline std::string remark_on(const mechanics::Law& law) {
  return law.index() == 0 ? "" : ", " + mechanics::name_of(law);
}

/// Prints a row of docs/verification.md on rank 0: what was checked, against
/// what, what came out and what is allowed, and the name of the running test.
/// `verification | grep '^|'` is the table.
void tell_figure(const std::string& what, const std::string& against, const std::string& measured,
                 const std::string& bound);

} // namespace prosup::tests

#endif
