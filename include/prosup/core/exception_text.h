#ifndef PROSUP_CORE_EXCEPTION_TEXT_H
#define PROSUP_CORE_EXCEPTION_TEXT_H

#include <exception>
#include <string>

namespace prosup {

/// What an exception of any library says, on one line and without a stack trace. Exceptions for
/// want of memory become a sentence that says so, and temporary files get the name that the user
/// knows (TemporaryName).
std::string text_of(const std::exception& exception);

/// Text with a blank for each sequence of blanks and line ends.
std::string on_one_line(const std::string& text);

} // namespace prosup

#endif
