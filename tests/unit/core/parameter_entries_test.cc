#include "prosup/core/parameter_entries.h"

#include <gtest/gtest.h>

namespace prosup::tests {
namespace {

TEST(ParameterEntries, HavePathsAndValues) {
  dealii::ParameterHandler parameters;
  parameters.declare_entry("Top", "1");
  parameters.enter_subsection("Image forces");
  parameters.declare_entry("Levels", "4, 2");
  parameters.enter_subsection("Deeper");
  parameters.declare_entry("File", "");
  parameters.leave_subsection();
  parameters.declare_entry("Weight", "0.1");
  parameters.set("Weight", "a = b # c");
  parameters.leave_subsection();
  const ParameterEntries expected{{"Top", "1"},
                                  {"Image forces/Levels", "4, 2"},
                                  {"Image forces/Deeper/File", ""},
                                  {"Image forces/Weight", "a = b # c"}};
  EXPECT_EQ(parameter_entries(parameters), expected);
}

} // namespace
} // namespace prosup::tests
