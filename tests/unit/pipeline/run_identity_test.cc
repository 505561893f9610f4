#include "pipeline/run_identity.h"

#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

// The header of an image may be the same when its voxels are not.
TEST(RunIdentity, CoversVoxelsInFilesOfTheirOwn) {
  const TemporaryFolder folder;
  const auto header = text_file(folder / "a.mhd", "NDims = 3\nDimSize = 2 1 1\nElementType = "
                                                  "MET_UCHAR\nElementDataFile = a.raw\n");
  dealii::ParameterHandler parameters;
  parameters.enter_subsection("Case");
  parameters.declare_entry("Prone image", header);
  parameters.declare_entry("Supine image", "");
  parameters.leave_subsection();
  text_file(folder / "a.raw", "ab");
  const auto before = pipeline::identity_of(parameters);
  EXPECT_EQ(pipeline::first_difference(before, pipeline::identity_of(parameters), "then"), "");
  text_file(folder / "a.raw", "ac");
  const std::string difference =
      pipeline::first_difference(before, pipeline::identity_of(parameters), "then");
  EXPECT_NE(difference.find("Case/Prone image"), std::string::npos) << difference;
}

} // namespace
} // namespace prosup::tests
