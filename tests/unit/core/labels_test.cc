#include "prosup/core/labels.h"

#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/core/parameters.h"

namespace prosup::tests {
namespace {

/// The labels that overrides from the command line give.
void read(const std::vector<Override>& overrides) {
  const Labels labels;
  dealii::ParameterHandler parameters;
  read_parameters(parameters, {}, overrides);
}

TEST(Labels, AreReadFromTheirSection) {
  const Labels labels;
  EXPECT_EQ(labels.fat(), 2u);
  dealii::ParameterHandler parameters;
  read_parameters(parameters, {}, {"Labels/Chest=9", "Labels/Tissues=4, 6, 5", "Labels/Gland=4"});
  EXPECT_EQ(labels.chest, 9u);
  EXPECT_EQ(labels.tissues, (std::vector<unsigned>{4, 6, 5}));
  EXPECT_EQ(labels.gland, 4u);
  EXPECT_EQ(labels.fat(), 6u);
}

TEST(Labels, NeedNoGland) {
  EXPECT_NO_THROW(read({"Labels/Tissues=7", "Labels/Gland=0"}));
}

// Many masks have 255 for tissue.
TEST(Labels, OfTissueDoNotMarkWhatIsUnknown) {
  const Labels labels;
  dealii::ParameterHandler parameters;
  read_parameters(parameters, {}, {"Labels/Tissues=255", "Labels/Gland=0"});
  EXPECT_EQ(labels.unknown, 0u);
}

TEST(Labels, ThatMakeNoSenseAreErrors) {
  expect_error([] { read({"Labels/Chest=2"}); }, {"label 2", "Labels/Tissues"});
  expect_error([] { read({"Labels/Tissues=2, 3, 2"}); }, {"label 2", "once"});
  expect_error([] { read({"Labels/Chest=0"}); }, {"Labels/Chest", "0 is air"});
  expect_error([] { read({"Labels/Tissues=0, 3"}); }, {"Labels/Tissues", "0 is air"});
  expect_error([] { read({"Labels/Gland=4"}); }, {"Labels/Gland", "4"});
  expect_error([] { read({"Labels/Unknown=2"}); }, {"label 2", "Labels/Unknown"});
  EXPECT_NO_THROW(read({"Labels/Unknown=0"}));
  Labels labels;
  labels.tissues = {labels.gland};
  expect_error([&] { labels.fat(); }, {"Labels/Tissues", "fat"});
  labels.tissues = {};
  expect_error([&] { labels.check(); }, {"Labels/Tissues", "empty"});
}

} // namespace
} // namespace prosup::tests
