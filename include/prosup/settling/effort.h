#ifndef PROSUP_SETTLING_EFFORT_H
#define PROSUP_SETTLING_EFFORT_H

namespace prosup::settling {

/// How much is tried before a body counts as one that does not settle.
struct Effort {
  Effort(unsigned max_steps = 0, bool gives_up_early = false) // implicit: a number of steps is one
      : max_steps(max_steps), gives_up_early(gives_up_early) {}

  unsigned max_steps; ///< 0: the parameter's, which is never exceeded
  /// The caller has something else to try: no return to a good state but where a small change, such
  /// as few nodes that are held, mends the cause, and no search for the reason.
  bool gives_up_early;
};

} // namespace prosup::settling

#endif
