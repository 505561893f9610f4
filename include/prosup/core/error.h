#ifndef PROSUP_CORE_ERROR_H
#define PROSUP_CORE_ERROR_H

#include <stdexcept>
#include <string>

#include "prosup/core/text.h"

namespace prosup {

/// An error that the user can correct. what() is one sentence: what is wrong, where, what is
/// allowed and what to do. Collective functions throw it on all ranks of their communicator.
/// What it quotes of a file or of the command line is made one printable line by
/// one_printable_line().
class Error : public std::runtime_error {
public:
  explicit Error(const std::string& message) : std::runtime_error(one_printable_line(message)) {}
};

/// A simulation has diverged (J <= 0, a value that is not finite, or growing energy), and smaller
/// steps or a longer lag did not help.
class DivergenceError : public Error {
public:
  using Error::Error;
};

} // namespace prosup

#endif
