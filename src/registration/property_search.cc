#include "property_search.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace prosup::registration {

using namespace dealii;

namespace {

/// A property as a number q without bounds near it, and what is allowed of it.
struct SearchedProperty {
  const char* name;
  double (*get)(const MechanicalProperties&);
  void (*set)(MechanicalProperties&, double q);
  double difference; ///< of q for derivatives
  double low, high;  ///< of q
};

const std::vector<SearchedProperty>& searched_properties() {
  static const std::vector<SearchedProperty> all{
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
       std::log(0.5), std::log(5.)},
      {"chest stiffness", [](const MechanicalProperties& p) { return std::log(p.chest_stiffness); },
       [](MechanicalProperties& p, double q) { p.chest_stiffness = std::exp(q); }, 0.2,
       std::log(0.5), std::log(200.)}};
  return all;
}

/// Those of `names` that the breasts have.
std::vector<const SearchedProperty*> chosen_of(const std::vector<std::string>& names,
                                               const MechanicalProperties& properties,
                                               bool has_gland) {
  std::vector<const SearchedProperty*> chosen;
  for (const SearchedProperty& property : searched_properties()) {
    const std::string name = property.name;
    if (std::find(names.begin(), names.end(), name) != names.end() &&
        (name != "gland ratio" || has_gland) &&
        (name != "chest stiffness" || properties.chest_stiffness > 0.))
      chosen.push_back(&property);
  }
  return chosen;
}

constexpr double longest_step = 0.7; // of a logarithm, a factor of two

/// Steps of one search.
class Search {
public:
  Search(std::vector<const SearchedProperty*> searched, PropertyTrials& trials,
         MaterialProgress& progress)
      : searched_(std::move(searched)), trials_(trials), residuals_(trials.residuals()),
        derivatives_(progress.derivatives), is_exact_(progress.is_exact) {
    if (derivatives_.empty())
      linearize();
    else
      set_equations();
  }

  bool is_exact() const { return is_exact_; }

  /// Derivatives by differences, one trial each.
  void linearize() {
    derivatives_.assign(searched_.size(), std::vector<float>(residuals_.size(), 0.f));
    for (unsigned i = 0; i < searched_.size(); ++i) {
      const double difference = searched_[i]->difference;
      if (trials_.unload(moved(i, difference))) {
        derivatives_[i] = trials_.residuals();
        for (std::size_t v = 0; v < residuals_.size(); ++v)
          derivatives_[i][v] =
              static_cast<float>((derivatives_[i][v] - residuals_[v]) / difference);
      }
      trials_.return_to_best();
    }
    is_exact_ = true;
    set_equations();
  }

  /// Goes on from the present, better state, with derivatives that explain how the
  /// residuals changed on the way there (Broyden's update).
  void accept(double value) {
    const MechanicalProperties before = trials_.best();
    trials_.accept(value);
    std::vector<double> way;
    double squared_length = 0.;
    for (const SearchedProperty* property : searched_) {
      way.push_back(property->get(trials_.best()) - property->get(before));
      squared_length += way.back() * way.back();
    }
    const std::vector<float> residuals = trials_.residuals();
    for (std::size_t v = 0; v < residuals.size() && squared_length > 0.; ++v) {
      double unexplained = residuals[v] - residuals_[v];
      for (unsigned i = 0; i < way.size(); ++i)
        unexplained -= derivatives_[i][v] * way[i];
      for (unsigned i = 0; i < way.size(); ++i)
        derivatives_[i][v] += static_cast<float>(unexplained * way[i] / squared_length);
    }
    residuals_ = residuals;
    is_exact_ = false;
    set_equations();
  }

  /// Where the damped step from the best state leads.
  MechanicalProperties step(double damping) const {
    const unsigned n = searched_.size();
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
      const SearchedProperty& property = *searched_[i];
      const double q =
          property.get(properties) - std::clamp(change[i], -longest_step, longest_step);
      property.set(properties, std::clamp(q, property.low, property.high));
    }
    return properties;
  }

private:
  MechanicalProperties moved(unsigned i, double difference) const {
    MechanicalProperties properties = trials_.best();
    searched_[i]->set(properties, searched_[i]->get(properties) + difference);
    return properties;
  }

  void set_equations() {
    const unsigned n = searched_.size();
    const auto product = [](const std::vector<float>& a, const std::vector<float>& b) {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    };
    curvature_.reinit(n, n);
    slope_.reinit(n);
    for (unsigned i = 0; i < n; ++i) {
      slope_[i] = product(residuals_, derivatives_[i]);
      for (unsigned j = 0; j < n; ++j)
        curvature_(i, j) = product(derivatives_[i], derivatives_[j]);
    }
  }

  const std::vector<const SearchedProperty*> searched_;
  PropertyTrials& trials_;
  std::vector<float> residuals_;                 // of the best state
  std::vector<std::vector<float>>& derivatives_; // of the residuals by each variable
  bool& is_exact_;
  FullMatrix<double> curvature_;
  Vector<double> slope_;
};

} // namespace

const std::vector<std::string>& property_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> names;
    for (const SearchedProperty& property : searched_properties())
      names.emplace_back(property.name);
    return names;
  }();
  return names;
}

void search_properties(const std::vector<std::string>& names, PropertyTrials& trials,
                       MaterialProgress& progress, unsigned max_steps, double least_gain,
                       bool to_the_end, const Keeper& keep) {
  const auto chosen = chosen_of(names, trials.best(), trials.has_gland());
  if (chosen.empty())
    return;
  double& damping = progress.damping;
  if (progress.derivatives.empty())
    damping = 1e-3;
  Search search(chosen, trials, progress);
  const double first = progress.first_value;
  while (progress.n_accepted < max_steps) {
    keep();
    const double before = trials.best_value();
    const bool was_exact = search.is_exact();
    bool improved = false;
    for (unsigned attempt = 0; attempt < (was_exact ? 4 : 1) && !improved; ++attempt) {
      const bool found = trials.unload(search.step(damping));
      const double value = found ? trials.value() : 0.;
      improved = found && value < before;
      damping = improved ? 0.1 * damping : std::max(10. * damping, 0.1);
      if (improved) {
        search.accept(value);
      } else {
        trials.return_to_best();
      }
    }
    if (before - trials.best_value() >= least_gain * (first - trials.best_value()) && improved)
      continue;
    if (was_exact || !to_the_end)
      break;
    search.linearize();
  }
}

std::vector<std::string> properties_at_bound(const std::vector<std::string>& names,
                                             const MechanicalProperties& properties,
                                             bool has_gland) {
  constexpr double near = 1e-3; // of a logarithm
  std::vector<std::string> found;
  for (const SearchedProperty* property : chosen_of(names, properties, has_gland)) {
    const double q = property->get(properties);
    // Springs as soft as can be are those of tissue that slides freely.
    const bool may_be_low = std::string(property->name) == "chest stiffness";
    if ((q < property->low + near && !may_be_low) || q > property->high - near)
      found.emplace_back(property->name);
  }
  return found;
}

} // namespace prosup::registration
