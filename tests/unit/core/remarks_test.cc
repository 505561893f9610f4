#include "prosup/core/remarks.h"

#include <gtest/gtest.h>

namespace prosup::tests {
namespace {

TEST(Remarks, AreToldOnceAndKeptInOrder) {
  Remarks remarks((Log(MPI_COMM_SELF)));
  testing::internal::CaptureStderr();
  for (const char* sentence : {"First.", "Second.", "First."})
    remarks.add(sentence);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "Warning: First.\nWarning: Second.\n");
  EXPECT_EQ(remarks.all(), (std::vector<std::string>{"First.", "Second."}));
}

TEST(Remarks, AreOnlyKeptWithoutALog) {
  Remarks remarks;
  testing::internal::CaptureStderr();
  remarks.add("First.");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(remarks.all().size(), 1u);
}

} // namespace
} // namespace prosup::tests
