#ifndef PROSUP_TESTS_ALL_LAWS_H
#define PROSUP_TESTS_ALL_LAWS_H

#include <vector>

#include "prosup/mechanics/laws/law.h"

namespace prosup::tests {

/// One of each law. Coefficients that a law has are 0.7, so that every term of it is tested.
inline std::vector<mechanics::Law> all_laws() {
  std::vector<mechanics::Law> laws;
  std::apply(
      [&](auto... law) {
        (law.coefficients([](const char*, double& value, auto&&...) { value = 0.7; }), ...);
        (laws.push_back(law), ...);
      },
      mechanics::AllLaws());
  return laws;
}

} // namespace prosup::tests

#endif
