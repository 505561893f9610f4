#ifndef PROSUP_CORE_ERROR_H
#define PROSUP_CORE_ERROR_H

#include <stdexcept>
#include <string>

namespace prosup {

/// A mistake the user can mend. what() is one sentence: what is wrong, where,
/// what is allowed and what to do. Thrown on all ranks of a communicator alike.
class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A simulation that left the region where its result means anything
/// (J <= 0, not a number, growing energy) and could not be saved by smaller
/// steps or a longer lag.
class DivergenceError : public Error {
public:
  using Error::Error;
};

} // namespace prosup

#endif
