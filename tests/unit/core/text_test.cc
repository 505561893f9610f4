#include "prosup/core/text.h"

#include <gtest/gtest.h>

#include "prosup/core/error.h"

namespace prosup::tests {
namespace {

TEST(Text, QuotedControlCharactersDoNotReachAMessage) {
  EXPECT_STREQ(Error(std::string("'a\nb\0c\x1b[2J\x7f' is wrong.", 18)).what(),
               "'a?b?c?[2J?' is wr");
  EXPECT_EQ(one_printable_line("Größe"), "Größe");
}

TEST(Text, LongMessagesLoseTheirMiddle) {
  const std::string text = "begin " + std::string(100000, 'x') + " end.";
  const std::string line = one_printable_line(text);
  EXPECT_LT(line.size(), 2000u);
  EXPECT_EQ(line.rfind("begin ", 0), 0u);
  EXPECT_TRUE(ends_with(line, "xxx end."));
  EXPECT_NE(line.find(" ... "), std::string::npos);
}

} // namespace
} // namespace prosup::tests
