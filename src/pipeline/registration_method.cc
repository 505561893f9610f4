#include "prosup/pipeline/registration_method.h"

#include "finite_differences.h"
#include "finite_elements.h"
#include "prosup/core/error.h"

namespace prosup::pipeline {

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names{"fe", "fdm"};
  return names;
}

std::unique_ptr<RegistrationMethod> make_method(const std::string& name, const Stages& stages,
                                                const registration::RankSplit& ranks,
                                                const Log& log) {
  if (name == "fe")
    return std::make_unique<FiniteElements>(stages, ranks, log);
  if (name == "fdm")
    return std::make_unique<FiniteDifferences>(stages, ranks, log);
  throw Error("There is no method '" + name + "'.");
}

} // namespace prosup::pipeline
