#include "refused.h"

namespace prosup::tests {
namespace {

class Prepare : public Refused {
protected:
  Arguments preparing(const Arguments& given) const {
    return Arguments{"prepare", "--output", output()} + given;
  }
};

TEST_F(Prepare, WithoutAScan) {
  for (const unsigned n_ranks : {1u, 2u})
    expect_refused(preparing({}), {"No scan", "--prone", "--supine"}, n_ranks);
}

TEST_F(Prepare, ScansThatAreNotThere) {
  expect_refused(preparing({"--prone", "nowhere.nii.gz"}), {"nowhere.nii.gz"}, 2);
}

TEST_F(Prepare, FoldersWithoutDicom) {
  expect_refused(preparing({"--prone", PROSUP_PRM_FOLDER}), {PROSUP_PRM_FOLDER, "no DICOM slices"});
}

TEST_F(Prepare, ChoicesThatDoNotExist) {
  const std::string scan = data_file("anthro1/prone.nii.gz");
  expect_refused(preparing({"--prone", scan, "--side", "middle"}), {"middle", "left"});
  expect_refused(preparing({"--prone", scan, "--contrast", "pet"}), {"pet", "t1fs"});
  expect_refused(preparing({"--prone", scan, "--series", "1,2,3"}), {"Series", "1,2,3"});
}

} // namespace
} // namespace prosup::tests
