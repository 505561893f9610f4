#include "descent_scheme.h"

#include <algorithm>
#include <deque>

#include "prosup/core/error.h"

namespace prosup::registration {

namespace {

constexpr double step_growth = 2.;
constexpr unsigned memory = 8; // steps that L-BFGS remembers

class GaussNewton : public DescentScheme {
public:
  explicit GaussNewton(const ImageEnergy& energy) : energy_(energy) {}

  bool needs_stiffness() const override { return true; }
  PairVectors direction(const ImageEnergyPoint& point, double kappa) override {
    return energy_.solve(point.similarity.stiffness, 2. * kappa, point.descent(kappa));
  }
  double shortest_part() const override { return 0.05; }

private:
  const ImageEnergy& energy_;
};

class SteepestDescent : public DescentScheme {
public:
  explicit SteepestDescent(const ImageEnergy& energy) : energy_(energy) {}

  PairVectors direction(const ImageEnergyPoint& point, double kappa) override {
    return energy_.solve({}, 0., point.descent(kappa));
  }
  double first_length(double last) const override { return std::min(1., step_growth * last); }

private:
  const ImageEnergy& energy_;
};

/// L-BFGS (Nocedal and Wright, algorithm 7.4) that starts from the inverse of K.
class LimitedMemory : public DescentScheme {
public:
  explicit LimitedMemory(const ImageEnergy& energy) : energy_(energy) {}

  bool remembers_steps() const override { return true; }
  PairVectors direction(const ImageEnergyPoint& point, double kappa) override {
    PairVectors q = point.descent(kappa);
    struct Pair {
      const PairVectors* way;
      PairVectors change; // of the gradient
      double curvature, alpha;
    };
    std::vector<Pair> pairs;
    for (const Step& step : steps_) {
      Pair pair{&step.way, step.image, 0., 0.};
      scale(pair.change, kappa);
      add(pair.change, 1., step.elastic);
      pair.curvature = energy_.product(pair.change, step.way);
      if (pair.curvature > 0.)
        pairs.push_back(std::move(pair));
    }
    for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair) {
      pair->alpha = energy_.product(*pair->way, q) / pair->curvature;
      add(q, -pair->alpha, pair->change);
    }
    double length = 1.;
    if (!pairs.empty())
      length = pairs.back().curvature /
               energy_.product(pairs.back().change, energy_.solve({}, 0., pairs.back().change));
    PairVectors direction = energy_.solve({}, 0., q);
    scale(direction, length);
    for (const Pair& pair : pairs)
      add(direction, pair.alpha - energy_.product(pair.change, direction) / pair.curvature,
          *pair.way);
    return direction;
  }

  void accept(const ImageEnergyPoint& from, const ImageEnergyPoint& to) override {
    Step step{to.unloaded, from.similarity.forces, to.elastic_force};
    add(step.way, -1., from.unloaded);
    add(step.image, -1., to.similarity.forces);
    add(step.elastic, -1., from.elastic_force);
    steps_.push_back(std::move(step));
    if (steps_.size() > memory)
      steps_.pop_front();
  }

private:
  /// With the changes of both parts of the gradient, since kappa changes too.
  struct Step {
    PairVectors way, image, elastic;
  };

  const ImageEnergy& energy_;
  std::deque<Step> steps_;
};

} // namespace

const std::vector<std::string>& descent_scheme_names() {
  static const std::vector<std::string> names{"gauss-newton", "l-bfgs", "steepest-descent"};
  return names;
}

std::unique_ptr<DescentScheme> make_descent_scheme(const std::string& name,
                                                   const ImageEnergy& energy) {
  if (name == "gauss-newton")
    return std::make_unique<GaussNewton>(energy);
  if (name == "l-bfgs")
    return std::make_unique<LimitedMemory>(energy);
  if (name == "steepest-descent")
    return std::make_unique<SteepestDescent>(energy);
  throw Error("There is no scheme '" + name + "' of image forces.");
}

} // namespace prosup::registration
