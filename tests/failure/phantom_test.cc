#include "refused.h"

namespace prosup::tests {
namespace {

class Phantom : public Refused {
protected:
  Arguments phantom(const std::string& setting) const {
    return {"phantom", PROSUP_PRM_FOLDER "/tests/phantom_small.prm", "--output", output(), "--set",
            setting};
  }
};

TEST_F(Phantom, SizesThatContradictEachOther) {
  for (const unsigned n_ranks : {1u, 2u})
    expect_refused(phantom("Phantom/Anatomy/Chest radius=45"),
                   {"Phantom/Anatomy/Chest radius", "45", "100"}, n_ranks);
}

TEST_F(Phantom, ValuesOutOfRange) {
  expect_refused(phantom("Phantom/Mechanics/Poisson ratio=0.5"), {"Poisson ratio", "0.5"});
  expect_refused(phantom("Phantom/Anatomy/Gland fraction=1.2"), {"Gland fraction", "1.2"});
  expect_refused(phantom("Phantom/Images/Rotation=0,0,90"), {"Rotation", "90"});
  expect_refused(phantom("Phantom/Images/Prone modality=US"), {"Prone modality", "US", "MR"});
  expect_refused(phantom("Phantom/Mechanics/Chest=floating"), {"Chest=floating", "sliding"});
}

TEST_F(Phantom, FieldOfViewThatShowsNothing) {
  expect_refused(phantom("Phantom/Images/Supine crop=40"), {"Supine crop", "smaller"});
}

TEST_F(Phantom, TissueTooSoftForItsWeight) {
  expect_refused(phantom("Phantom/Mechanics/Fat shear modulus=1") +
                     Arguments{"--set", "Phantom/Mechanics/Mesh edge length=16", "--set",
                               "Quasi-static/Maximum halvings=1", "--set",
                               "Quasi-static/Maximum iterations=5"},
                 {"load"}, 2);
}

TEST_F(Phantom, LoadOfAMeshThatIsNone) {
  expect_refused({"load", "--output", output(), "--set", "Single state/Mesh=nowhere.vtu"},
                 {"nowhere.vtu", "does not exist"});
  expect_refused({"load", "--output", output()}, {"Prone labels", "--prone-labels"});
}

} // namespace
} // namespace prosup::tests
