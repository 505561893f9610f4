#ifndef PROSUP_CORE_REMARKS_H
#define PROSUP_CORE_REMARKS_H

#include <string>
#include <vector>

#include "prosup/core/log.h"

namespace prosup {

/// Doubts about the input that are no errors: each is one sentence that says what is doubtful,
/// where, what was assumed and what to do. They are told when they arise, so that they precede
/// what may fail because of them, and kept for `warnings` of summary.json. For one rank.
class Remarks {
public:
  /// `log` is told of each; by default they are only kept.
  explicit Remarks(const Log& log = Log()) : log_(log) {}

  /// Says and keeps `sentence`, made printable as that of an Error, unless it was said before.
  void add(const std::string& sentence);

  /// In the order in which they came.
  const std::vector<std::string>& all() const { return all_; }

private:
  Log log_;
  std::vector<std::string> all_;
};

} // namespace prosup

#endif
