#ifndef PROSUP_TESTS_EXPECT_ERROR_H
#define PROSUP_TESTS_EXPECT_ERROR_H

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "prosup/core/error.h"

namespace prosup::tests {

/// Expects `action` to throw prosup::Error with one sentence that holds all of
/// `fragments`.
template <typename Action>
void expect_error(const Action& action, const std::vector<std::string>& fragments) {
  try {
    action();
  } catch (const Error& error) {
    const std::string message = error.what();
    for (const std::string& fragment : fragments)
      EXPECT_NE(message.find(fragment), std::string::npos)
          << "'" << fragment << "' is not in: " << message;
    ASSERT_FALSE(message.empty());
    EXPECT_EQ(message.back(), '.') << message;
    EXPECT_EQ(message.find(". "), std::string::npos) << "more than one sentence: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return;
  }
  ADD_FAILURE() << "no error was thrown";
}

} // namespace prosup::tests

#endif
