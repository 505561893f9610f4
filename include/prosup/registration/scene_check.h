#ifndef PROSUP_REGISTRATION_SCENE_CHECK_H
#define PROSUP_REGISTRATION_SCENE_CHECK_H

#include <deal.II/base/parameter_acceptor.h>

#include <optional>
#include <string>
#include <vector>

#include "prosup/registration/inputs.h"

namespace prosup::registration {

/// A fault of the input that was found without any simulation.
struct Finding {
  /// What it means for a result.
  enum class Severity {
    warning, ///< the result is in doubt
    error    ///< no result can be right
  };
  Severity severity = Severity::warning;
  std::string text; ///< one sentence: what, how much, and what to do
};

/// What the check of a scene has found: faults, the worst first, and what was measured.
struct SceneReport {
  std::vector<Finding> findings;
  std::string measures; ///< a table for the reader, of a few lines

  /// Number of findings with which no result can be right.
  std::size_t n_errors() const;
  /// Adds all findings to `remarks`.
  void tell(Remarks& remarks) const;
};

/// Checks labels, images and gravity of a case against each other before any simulation, on voxels
/// only, section "Checks". What is checked, and the limits, are in docs/checks.md.
class SceneCheck : public dealii::ParameterAcceptor {
public:
  /// Keeps a reference to `labels`.
  explicit SceneCheck(const Labels& labels);
  explicit SceneCheck(Labels&&) = delete;
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// Both breasts, for one rank. `gravity` is in the coordinates of the scene.
  SceneReport check_pair(const Inputs& inputs, const PerPosition<dealii::Tensor<1, 3>>& gravity,
                         bool needs_same_contrast) const;

  /// The breast of one position alone, for one rank; without gravity if it does not matter. There
  /// is nothing to compare it with, so that its errors should not stop a run.
  SceneReport check_one(const image::LabelImage& labels, Position position,
                        const std::optional<dealii::Tensor<1, 3>>& gravity = {}) const;

  /// Tells the findings to `remarks` if the run may go on with them.
  /// @throws Error with the first error and the number of other findings, if errors stop the run.
  void accept(const SceneReport& report, Remarks& remarks) const;

private:
  bool stops_ = true;
  const Labels& labels_;
};

} // namespace prosup::registration

#endif
