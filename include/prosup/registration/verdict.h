#ifndef PROSUP_REGISTRATION_VERDICT_H
#define PROSUP_REGISTRATION_VERDICT_H

#include <string>
#include <vector>

#include "prosup/registration/quality.h"

namespace prosup::registration {

/// How far a registration can be trusted: good, look at the reasons first, or not at all.
enum class Grade { good, doubtful, failed };

/// "good", "doubtful" or "failed".
const char* name_of(Grade grade);

/// A grade and the reasons for it.
struct Verdict {
  Grade grade = Grade::good;
  /// One sentence each, worst first: the number, what is usual, and what to do.
  std::vector<std::string> reasons;
};

/// Judges a registration by what it has left. The limits are in src/registration/verdict.cc, and
/// docs/verdict.md shows the figures of right and wrong uses from which they were chosen. Landmarks
/// have no part in it.
Verdict judge(const Quality& quality);

} // namespace prosup::registration

#endif
