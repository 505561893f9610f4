#include "property_search.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace prosup::registration {

using namespace dealii;

namespace {

/// A property as a number q without bounds near it, and what is allowed of it.
struct Variable {
  const char* name;
  double (*get)(const MechanicalProperties&);
  void (*set)(MechanicalProperties&, double q);
  double difference; ///< of q for derivatives
  double low, high;  ///< of q
};

const std::vector<Variable>& variables() {
  static const std::vector<Variable> all{
      {"shear modulus",
       [](const MechanicalProperties& p) { return std::log(p.tissue.shear_modulus); },
       [](MechanicalProperties& p, double q) { p.tissue.shear_modulus = std::exp(q); }, 0.1,
       std::log(10.), std::log(1e5)},
      // log(1 - 2 nu): the bulk modulus over the shear modulus is 1/(1 - 2 nu) - 1/3
      {"Poisson ratio",
       [](const MechanicalProperties& p) { return std::log(1. - 2. * p.tissue.poisson_ratio); },
       [](MechanicalProperties& p, double q) { p.tissue.poisson_ratio = 0.5 * (1. - std::exp(q)); },
       -0.2, std::log(0.02), std::log(0.5)},
      {"gland ratio", [](const MechanicalProperties& p) { return std::log(p.tissue.gland_ratio); },
       [](MechanicalProperties& p, double q) { p.tissue.gland_ratio = std::exp(q); }, 0.2,
       std::log(0.5), std::log(8.)},
      {"chest stiffness", [](const MechanicalProperties& p) { return std::log(p.chest_stiffness); },
       [](MechanicalProperties& p, double q) { p.chest_stiffness = std::exp(q); }, 0.2,
       std::log(0.1), std::log(1000.)}};
  return all;
}

constexpr double longest_step = 0.7; // of a logarithm, a factor of two

/// Steps of one search.
class Search {
public:
  Search(std::vector<const Variable*> variables, PropertyTrials& trials)
      : variables_(std::move(variables)), trials_(trials) {}

  void linearize() {
    const std::vector<float> residuals = trials_.residuals();
    const unsigned n = variables_.size();
    std::vector<std::vector<float>> derivatives(n, std::vector<float>(residuals.size(), 0.f));
    for (unsigned i = 0; i < n; ++i) {
      const double difference = variables_[i]->difference;
      if (trials_.unload(moved(i, difference))) {
        derivatives[i] = trials_.residuals();
        for (std::size_t v = 0; v < residuals.size(); ++v)
          derivatives[i][v] = static_cast<float>((derivatives[i][v] - residuals[v]) / difference);
      }
      trials_.return_to_best();
    }
    curvature_.reinit(n, n);
    slope_.reinit(n);
    for (unsigned i = 0; i < n; ++i) {
      for (std::size_t v = 0; v < residuals.size(); ++v)
        slope_[i] += static_cast<double>(residuals[v]) * derivatives[i][v];
      for (unsigned j = 0; j <= i; ++j) {
        double sum = 0.;
        for (std::size_t v = 0; v < residuals.size(); ++v)
          sum += static_cast<double>(derivatives[i][v]) * derivatives[j][v];
        curvature_(i, j) = curvature_(j, i) = sum;
      }
    }
  }

  /// Where the damped step from the best state leads.
  MechanicalProperties step(double damping) const {
    const unsigned n = variables_.size();
    FullMatrix<double> matrix(curvature_);
    double largest = 0.;
    for (unsigned i = 0; i < n; ++i)
      largest = std::max(largest, curvature_(i, i));
    if (!(largest > 0.)) // nothing changes the images
      return trials_.best();
    for (unsigned i = 0; i < n; ++i)
      matrix(i, i) += damping * curvature_(i, i) + 1e-6 * largest;
    Vector<double> change(n);
    FullMatrix<double> inverse(n, n);
    inverse.invert(matrix);
    inverse.vmult(change, slope_);
    MechanicalProperties properties = trials_.best();
    for (unsigned i = 0; i < n; ++i) {
      const Variable& variable = *variables_[i];
      const double q =
          variable.get(properties) - std::clamp(change[i], -longest_step, longest_step);
      variable.set(properties, std::clamp(q, variable.low, variable.high));
    }
    return properties;
  }

private:
  MechanicalProperties moved(unsigned i, double difference) const {
    MechanicalProperties properties = trials_.best();
    variables_[i]->set(properties, variables_[i]->get(properties) + difference);
    return properties;
  }

  const std::vector<const Variable*> variables_;
  PropertyTrials& trials_;
  FullMatrix<double> curvature_;
  Vector<double> slope_;
};

} // namespace

const std::vector<std::string>& property_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> names;
    for (const Variable& variable : variables())
      names.emplace_back(variable.name);
    return names;
  }();
  return names;
}

void search_properties(const std::vector<std::string>& names, PropertyTrials& trials,
                       bool has_gland, unsigned max_steps, double least_gain) {
  std::vector<const Variable*> chosen;
  for (const Variable& variable : variables()) {
    const std::string name = variable.name;
    if (std::find(names.begin(), names.end(), name) != names.end() &&
        (name != "gland ratio" || has_gland) &&
        (name != "chest stiffness" || trials.best().chest_stiffness > 0.))
      chosen.push_back(&variable);
  }
  if (chosen.empty())
    return;
  Search search(chosen, trials);
  double damping = 1e-3;
  for (unsigned i = 0; i < max_steps; ++i) {
    search.linearize();
    const double before = trials.best_value();
    bool improved = false;
    for (unsigned attempt = 0; attempt < 4 && !improved; ++attempt) {
      const bool found = trials.unload(search.step(damping));
      const double value = found ? trials.value() : 0.;
      improved = found && value < before;
      if (improved)
        trials.accept(value);
      else
        trials.return_to_best();
      damping = improved ? 0.1 * damping : std::max(10. * damping, 0.1);
    }
    if (!improved || before - trials.best_value() < least_gain * before)
      break;
  }
}

} // namespace prosup::registration
