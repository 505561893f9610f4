#ifndef PROSUP_BENCHMARKS_HARD_CASES_RUNNER_H
#define PROSUP_BENCHMARKS_HARD_CASES_RUNNER_H

#include "cases.h"

namespace prosup::benchmarks {

/// What came of a case.
struct Result {
  unsigned n_cells = 0, n_steps = 0, n_retries = 0;
  double distance = 0.;        ///< of the unloaded positions to Newton's, largest at a node, mm
  bool is_compared = false;    ///< Newton's method has a solution, and so has the unloading
  double newton_fraction = 0.; ///< of the weight, up to which Newton's method has a solution
  double seconds = 0.;         ///< of the unloading
  bool is_finite = true;       ///< no NaN in what the unloading leaves
  Outcome outcome = Outcome::settled;
  std::string explanation; ///< what the unloading said
  bool as_expected = false;
};

enum class Size { small, full };

/// Collective on all ranks.
Result run(const Case& hard_case, Size size);

} // namespace prosup::benchmarks

#endif
