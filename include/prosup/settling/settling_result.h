#ifndef PROSUP_SETTLING_SETTLING_RESULT_H
#define PROSUP_SETTLING_SETTLING_RESULT_H

#include <string>
#include <vector>

namespace prosup::settling {

/// The outcome of one call of run() or advance().
struct SettlingResult {
  bool converged = false;   ///< all tolerances are met
  unsigned n_steps = 0;     ///< time steps, including those that were undone
  unsigned n_retries = 0;   ///< returns to a good state
  double residual = 0.;     ///< norm of the out-of-balance forces over that of the weight
  double distance = 0.;     ///< largest error of the unloaded positions, mm
  double min_jacobian = 0.; ///< smallest J = det dx/dX
  std::string explanation;  ///< why run() ended without convergence, otherwise empty
  /// What is doubtful about the body or its state, each a sentence.
  std::vector<std::string> remarks;

  template <typename Archive>
  void serialize(Archive& archive, unsigned) {
    archive& converged& n_steps& n_retries& residual& distance& min_jacobian& explanation& remarks;
  }
};

} // namespace prosup::settling

#endif
