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

TEST_F(Prepare, AMaskWithoutItsScan) {
  const std::string scan = data_file("anthro1/prone.nii.gz"),
                    mask = data_file("anthro1/supine_labels.nii.gz");
  expect_refused(preparing({"--prone", scan, "--supine-chest", mask}),
                 {mask, "supine scan", "--supine FILE"});
}

TEST_F(Prepare, AMaskThatIsNotThere) {
  const std::string scan = data_file("anthro1/prone.nii.gz");
  expect_refused(preparing({"--prone", scan, "--prone-gland", "nowhere.nii.gz"}),
                 {"nowhere.nii.gz"}, 2);
}

TEST_F(Prepare, ScansAndLabelsOfOnePosition) {
  const std::string scan = data_file("small/prone.nii.gz");
  expect_refused(registering({"--prone", scan}),
                 {"For prone both a scan", "--prone-labels", "leave out"}, 2);
}

TEST_F(Prepare, ARegistrationWithOneScanAndNothingElse) {
  expect_refused({"register", "--prone", data_file("small/prone.nii.gz"), "--output", output()},
                 {"Case/Supine image", "--supine-image"});
}

} // namespace
} // namespace prosup::tests
