#include "refused.h"

namespace prosup::tests {
namespace {

class Compare : public Refused {
protected:
  Arguments comparing(const Arguments& wrong) const {
    return Arguments{"compare", PROSUP_PRM_FOLDER "/tests/small.prm", "--output", output()} + wrong;
  }
};

TEST_F(Compare, WithoutRuns) {
  expect_refused(comparing({}), {"nothing to compare", "Comparison/Runs"});
}

TEST_F(Compare, RunsThatCannotBeRead) {
  for (const char* runs : {"FE: --set a=b", "FE/: --set a=b", "FE/x", "/x: ", "FE/a,,b: "})
    expect_refused(comparing({"--set", std::string("Comparison/Runs=") + runs}),
                   {"Comparison/Runs", "group/name"});
  expect_refused(comparing({"--set", "Comparison/Runs=FE/a: ; FE/a: "}), {"FE/a", "twice"});
  expect_refused(comparing({"--set", "Comparison/Runs=FE/a: --set \"b=c"}), {"double quote"});
}

TEST_F(Compare, UnderMpirun) {
  for (const unsigned n_ranks : {2u, 3u})
    expect_refused(comparing({"--set", "Comparison/Runs=FE/a: "}), {"without mpirun", "Ranks"},
                   n_ranks);
}

TEST_F(Compare, PeersThatAreNotKnownOrHaveNothingToDo) {
  expect_refused(comparing({"--set", "Comparison/Peers=magic-wand"}),
                 {"magic-wand", "elastix", "plastimatch"});
  expect_refused(
      comparing({"--set", "Comparison/Peers=elastix", "--set", "Comparison/Command=unload"}),
      {"unload", "Comparison/Peers"});
}

TEST_F(Compare, OutputFolderWithForeignContent) {
  write("summary.json", "years of work");
  expect_refused(Arguments{"compare", PROSUP_PRM_FOLDER "/tests/small.prm", "--set",
                           "Comparison/Runs=FE/a: ", "--output", folder_ / ""},
                 {"summary.json", "--output"});
  EXPECT_EQ(contents(folder_ / "summary.json"), "years of work");
}

} // namespace
} // namespace prosup::tests
