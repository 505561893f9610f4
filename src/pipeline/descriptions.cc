#include "prosup/pipeline/descriptions.h"

#include "prosup/core/log.h"

namespace prosup::pipeline {

std::string describe(const std::string& name, const settling::SettlingResult& result) {
  return format("  %s: %u steps, residual %.1e, max |x-u-X| %.3f mm, min J %.2f%s%s%s",
                name.c_str(), result.n_steps, result.residual, result.distance, result.min_jacobian,
                result.converged ? "" : " (NOT settled)", result.explanation.empty() ? "" : "\n  ",
                result.explanation.c_str());
}

std::string describe(const std::string& name, const mechanics::QuasiStaticResult& result) {
  return format("  %s: %u Newton steps in %u load steps, residual %.1e, min J %.2f%s", name.c_str(),
                result.n_newton_steps, result.n_load_steps, result.residual, result.min_jacobian,
                result.converged ? "" : " (NOT converged)");
}

} // namespace prosup::pipeline
