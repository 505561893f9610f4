#include "refused.h"

namespace prosup::tests {
namespace {

using Parameters = Refused;

TEST_F(Parameters, FileThatDoesNotExist) {
  expect_refused({"register", "nowhere.prm", "--output", output()},
                 {"nowhere.prm", "does not exist"});
  expect_refused({"register", "nowhere.prm", "--output", output()}, {"nowhere.prm"}, 2);
}

TEST_F(Parameters, UnknownEntryInTheFile) {
  const std::string file = write("wrong.prm", "subsection Unloading\n  set Lagg = 0.1\nend\n");
  expect_refused({"register", file, "--output", output()}, {file, "Lagg", "--write-prm"});
}

TEST_F(Parameters, UnknownSectionInTheFile) {
  const std::string file = write("wrong.prm", "subsection Unlading\n  set Lag = 0.1\nend\n");
  expect_refused({"unload", file, "--output", output()}, {file, "Unlading", "--write-prm"}, 2);
}

TEST_F(Parameters, ValueOutOfRangeInTheFile) {
  const std::string file =
      write("wrong.prm", "subsection Material\n  set Poisson ratio = 0.7\nend\n");
  expect_refused({"register", file, "--output", output()}, {file, "0.7", "Poisson ratio"});
}

TEST_F(Parameters, LogLevelThatDoesNotExistOrIsGivenTwice) {
  expect_refused(registering({"--log-level", "loud"}),
                 {"--log-level", "loud", "error", "warning", "info", "debug"});
  expect_refused(registering({"--log-level", "debug", "--quiet"}), {"--log-level", "--quiet"});
}

TEST_F(Parameters, UnknownEntryOrSectionOfSet) {
  expect_refused(registering({"--set", "Unloading/Lagg=1"}), {"Unloading/Lagg=1", "--write-prm"});
  expect_refused(registering({"--set", "Unlading/Lag=1"}), {"Unlading/Lag=1", "section"});
  expect_refused(registering({"--set", "Unlading/Lag=1"}), {"Unlading/Lag=1", "section"}, 2);
  expect_refused(registering({"--set", "Unloading/Lag factor"}), {"Unloading/Lag factor", "'='"});
}

TEST_F(Parameters, ValueOutOfRange) {
  expect_refused(registering({"--set", "Unloading/Density=-1"}), {"Density", "-1"});
  expect_refused(registering({"--set", "Meshing/Edge length=long"}), {"Edge length", "long"});
}

TEST_F(Parameters, UnknownChoiceIsAnsweredWithTheList) {
  expect_refused(registering({"--chest", "glued"}), {"Chest=glued", "fixed"});
  expect_refused(registering({"--similarity", "psychic"}), {"Metric=psychic", "ssd"});
  expect_refused(registering({"--method", "magic"}), {"Method=magic", "fe"});
  expect_refused({"unload", "--state", "asleep", "--output", output()},
                 {"State=asleep", "prone", "supine"});
  expect_refused(registering({"--set", "Unloading/Correction scheme=none"}),
                 {"Correction scheme=none", "relaxed", "full"});
  expect_refused(registering({"--set", "Unloading/Lag factor=0"}), {"Lag factor=0"});
  expect_refused(registering({"--similarity", "psychic"}), {"Metric=psychic", "ssd"}, 2);
}

TEST_F(Parameters, GravityWithoutDirection) {
  for (const unsigned n_ranks : {1u, 2u})
    expect_refused(registering({"--prone-gravity", "0,0,0"}), {"Prone gravity", "0,-1,0"}, n_ranks);
  expect_refused(registering({"--supine-gravity", "0,1"}), {"Supine gravity=0,1"});
  expect_refused(registering({"--supine-gravity", "down"}), {"Supine gravity=down"});
}

} // namespace
} // namespace prosup::tests
