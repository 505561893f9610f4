#ifndef PROSUP_PIPELINE_OUTCOME_H
#define PROSUP_PIPELINE_OUTCOME_H

namespace prosup::pipeline {

/// How a command ended that wrote its results. The values are exit codes of the program; an error,
/// after which there are no results, has 1.
enum class Outcome : int {
  success = 0,
  not_settled = 2, ///< a simulation did not settle
  failed = 3       ///< the verdict on a registration, registration::Grade::failed
};

/// Of commands that can only have settled or not.
constexpr Outcome outcome_of(bool settled) {
  return settled ? Outcome::success : Outcome::not_settled;
}
constexpr Outcome outcome_of(Outcome outcome) {
  return outcome;
}

} // namespace prosup::pipeline

#endif
