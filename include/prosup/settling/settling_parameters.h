#ifndef PROSUP_SETTLING_SETTLING_PARAMETERS_H
#define PROSUP_SETTLING_SETTLING_PARAMETERS_H

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace prosup::settling {

/// How the unloaded configuration is corrected every n steps of length h.
enum class CorrectionScheme {
  relaxed, ///< by the part min(1, n h/tau) of the predicted correction
  full     ///< by all of it, as in the paper (its eq. 9)
};

/// Names of the schemes, in the order of the enumerators.
const std::vector<std::string>& correction_names();

/// The parameters of Settling. Each numerical method declares them in its own
/// section, with its own symbols.
struct SettlingParameters {
  explicit SettlingParameters(double step_safety);

  CorrectionScheme correction_scheme() const;

  std::string correction;            ///< of correction_names()
  double lag_factor = 2.5;           ///< tau r/rho of the relaxed correction
  unsigned correction_interval = 10; ///< n, steps
  double gravity_ramp = 1.;          ///< in damping times 1/(r/rho)
  double residual_tolerance = 2e-3;  ///< relative to the weight
  double position_tolerance = 0.02;  ///< mm
  unsigned max_steps = 20000;
  double step_safety; ///< time step over the critical one
  unsigned max_retries = 6;

protected:
  /// The symbols of a method, for the documentation of its parameters.
  struct Symbols {
    std::string corrected; ///< what is corrected, "unloaded positions X"
    std::string relaxed;   ///< the relaxed correction, "X <- X + min(1, n h/tau) (x - u - X)"
    std::string full;      ///< the full correction, "X <- x - u"
    std::string error;     ///< the error of the position, "max |x - u - X|"
    std::string remedies;  ///< what a retry changes
  };
  void declare(dealii::ParameterHandler& prm, const Symbols& symbols);
};

} // namespace prosup::settling

#endif
