#ifndef PROSUP_CORE_ERROR_H
#define PROSUP_CORE_ERROR_H

#include <stdexcept>
#include <string>

namespace prosup {

/// An error that the user can correct. what() is one sentence: what is wrong, where, what is
/// allowed and what to do. Collective functions throw it on all ranks of their communicator.
class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A simulation has diverged (J <= 0, a value that is not finite, or growing energy), and smaller
/// steps or a longer lag did not help.
class DivergenceError : public Error {
public:
  using Error::Error;
};

} // namespace prosup

#endif
