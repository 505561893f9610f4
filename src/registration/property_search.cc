#include "property_search.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "searched_property.h"

namespace prosup::registration {

using namespace dealii;

namespace {

/// Those of `names` that the breasts have and that this level is to find.
std::vector<const SearchedProperty*> chosen_of(const std::vector<std::string>& names,
                                               const MechanicalProperties& properties,
                                               const PropertiesOfPair& pair, bool is_finest) {
  std::vector<const SearchedProperty*> chosen;
  for (const SearchedProperty& property : searched_properties()) {
    const std::string name = property.name;
    if (std::find(names.begin(), names.end(), name) != names.end() &&
        (is_finest || !property.is_subtle) && (name != "gland ratio" || pair.has_gland) &&
        (name != "chest stiffness" || properties.chest_stiffness > 0.) &&
        (name != "lateral chest ratio" ||
         (properties.chest_stiffness > 0. && pair.consists_of_elements)) &&
        (name != "cut plane stiffness" || properties.cut_plane_stiffness.prone > 0.) &&
        (name != "gravity" || pair.can_tilt) &&
        (name != "skin stiffness" || pair.consists_of_elements))
      chosen.push_back(&property);
  }
  return chosen;
}

// Corrected derivatives lead along valleys: without new ones a pair whose breast was pushed by a
// coil ended at 3.7 mm, with a bed four times too stiff, instead of 3.1 mm and twice.
constexpr unsigned steps_per_linearization = 3;

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

  /// Derivatives of the best state: exact, or by differences, one trial each.
  void linearize() {
    std::optional<PropertyTrials::Linearization> exact;
    if (trials_.can_derive())
      exact = trials_.linearize(searched_);
    if (exact) {
      residuals_ = std::move(exact->residuals);
      derivatives_ = std::move(exact->derivatives);
    } else {
      derive_by_trials();
    }
    is_exact_ = true;
    set_equations();
  }

  /// Goes on from the present, better state. Derivatives from trials are corrected to explain how
  /// the residuals changed on the way there (Broyden's update); exact ones are found anew.
  void accept(double value) {
    const MechanicalProperties before = trials_.best();
    trials_.accept(value);
    is_exact_ = false;
    if (trials_.can_derive())
      return;
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
    set_equations();
  }

  /// What the prior adds to the dissimilarity.
  double prior(const MechanicalProperties& properties) const {
    double sum = 0.;
    for (unsigned i = 0; i < searched_.size(); ++i) {
      sum += searched_[i]->surprise(properties);
      if (const double unlike = difference_within_name(i, properties); unlike != 0.)
        sum += 0.5 * std::pow(unlike / searched_[i]->alike, 2);
    }
    return prior_weight_ * sum;
  }

  /// Where the damped step from the best state leads.
  MechanicalProperties step(double damping) const {
    const unsigned n = searched_.size();
    MechanicalProperties properties = trials_.best();
    FullMatrix<double> matrix(curvature_);
    Vector<double> slope(slope_), change(n);
    double largest = 0.;
    for (unsigned i = 0; i < n; ++i) {
      const SearchedProperty& property = *searched_[i];
      largest = std::max(largest, curvature_(i, i));
      const double information = prior_weight_ / (property.deviation * property.deviation);
      matrix(i, i) += information;
      slope[i] += information * (property.get(properties) - property.mean);
      if (is_alike(i)) {
        const double likeness = prior_weight_ / (property.alike * property.alike),
                     unlike = difference_within_name(i, properties);
        matrix(i, i) += likeness;
        matrix(i - 1, i - 1) += likeness;
        matrix(i, i - 1) -= likeness;
        matrix(i - 1, i) -= likeness;
        slope[i] += likeness * unlike;
        slope[i - 1] -= likeness * unlike;
      }
    }
    if (!(largest > 0.)) // nothing changes the images
      return properties;
    for (unsigned i = 0; i < n; ++i)
      matrix(i, i) += damping * matrix(i, i) + 1e-6 * largest;
    FullMatrix<double> inverse(n, n);
    inverse.invert(matrix);
    inverse.vmult(change, slope);
    for (unsigned i = 0; i < n; ++i) {
      const SearchedProperty& property = *searched_[i];
      const double q = property.get(properties) -
                       std::clamp(change[i], -property.longest_step, property.longest_step);
      property.set(properties, std::clamp(q, property.low, property.high));
    }
    return properties;
  }

private:
  bool is_alike(unsigned i) const { return searched_[i]->alike > 0.; }

  /// Of q from that of the property which it is like; 0 if there is none.
  double difference_within_name(unsigned i, const MechanicalProperties& properties) const {
    return is_alike(i) ? searched_[i]->get(properties) - searched_[i - 1]->get(properties) : 0.;
  }

  void derive_by_trials() {
    residuals_ = trials_.residuals();
    derivatives_.assign(searched_.size(), std::vector<float>(residuals_.size(), 0.f));
    for (unsigned i = 0; i < searched_.size(); ++i) {
      const SearchedProperty& property = *searched_[i];
      MechanicalProperties moved = trials_.best();
      const double q = property.get(moved), ahead = q + property.difference;
      const bool is_inside = ahead >= property.low && ahead <= property.high;
      const double difference = is_inside ? property.difference : -property.difference;
      property.set(moved, q + difference);
      if (trials_.unload(moved)) {
        derivatives_[i] = trials_.residuals();
        for (std::size_t v = 0; v < residuals_.size(); ++v)
          derivatives_[i][v] =
              static_cast<float>((derivatives_[i][v] - residuals_[v]) / difference);
      }
      trials_.return_to_best();
    }
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
    prior_weight_ = trials_.prior_weight(least_value());
  }

  /// What linear residuals would leave of the dissimilarity. The prior is weighed by it, since what
  /// the properties can explain is no error.
  double least_value() const {
    const unsigned n = searched_.size();
    FullMatrix<double> matrix(curvature_), inverse(n, n);
    for (unsigned i = 0; i < n; ++i)
      matrix(i, i) += 1e-3 * curvature_(i, i) + std::numeric_limits<double>::min();
    inverse.invert(matrix);
    Vector<double> change(n);
    inverse.vmult(change, slope_);
    return std::max(trials_.best_value() - 0.5 * (slope_ * change), 0.);
  }

  const std::vector<const SearchedProperty*> searched_;
  PropertyTrials& trials_;
  std::vector<float> residuals_;                 // of the best state
  std::vector<std::vector<float>>& derivatives_; // of the residuals by each variable
  bool& is_exact_;
  FullMatrix<double> curvature_;
  Vector<double> slope_;
  double prior_weight_ = 0.;
};

} // namespace

const std::vector<std::string>& property_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> names;
    for (const SearchedProperty& property : searched_properties())
      if (names.empty() || names.back() != property.name)
        names.emplace_back(property.name);
    return names;
  }();
  return names;
}

void search_properties(const std::vector<std::string>& names, PropertyTrials& trials,
                       MaterialProgress& progress, unsigned max_steps, double least_gain,
                       bool to_the_end, const Keeper& keep) {
  const auto chosen = chosen_of(names, trials.best(), trials.pair(), to_the_end);
  if (chosen.empty())
    return;
  double& damping = progress.damping;
  if (progress.derivatives.empty())
    damping = 1e-3;
  Search search(chosen, trials, progress);
  const double first = progress.first_value;
  while (progress.n_accepted < max_steps) {
    keep();
    if (progress.n_accepted > 0 && !search.is_exact() &&
        (trials.can_derive() || progress.n_accepted % steps_per_linearization == 0))
      search.linearize();
    const double before = trials.best_value();
    const bool was_exact = search.is_exact();
    bool improved = false;
    for (unsigned attempt = 0; attempt < (was_exact ? 4 : 1) && !improved; ++attempt) {
      const MechanicalProperties next = search.step(damping);
      const bool found = trials.unload(next);
      const double value = found ? trials.value() : 0.;
      improved = found && value + search.prior(next) < before + search.prior(trials.best());
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
                                             const PropertiesOfPair& pair) {
  constexpr double near = 1e-3; // of a logarithm
  std::vector<std::string> found;
  for (const SearchedProperty* property : chosen_of(names, properties, pair, true)) {
    const double q = property->get(properties);
    const bool is_at_bound =
        (q < property->low + near && !property->may_be_low) || q > property->high - near;
    if (is_at_bound && (found.empty() || found.back() != property->name))
      found.emplace_back(property->name);
  }
  return found;
}

} // namespace prosup::registration
