#include "refused.h"

namespace prosup::tests {
namespace {

class Run : public Refused {
protected:
  std::string points(const std::string& text) const { return write("points.csv", text); }

  Arguments mapping(const std::string& result, const std::string& from, const std::string& to,
                    const std::string& file) const {
    return {"map", "--result", result, "--from", from, "--to", to, file, "-o", output()};
  }
};

// No body of this size can carry its weight with this stiffness.
TEST_F(Run, MaterialTooSoft) {
  for (const unsigned n_ranks : {1u, 2u})
    expect_refused(registering({"--set", "Material/Shear modulus=2"}),
                   {"diverged", "Material/Shear modulus"}, n_ranks);
}

TEST_F(Run, FiniteDifferencesWithAModelThatTheyDoNotHave) {
  for (const unsigned n_ranks : {1u, 2u})
    expect_refused(registering({"--method", "fdm", "--set", "Material/Model=yeoh"}),
                   {"Material/Model", "yeoh", "neo-hookean", "finite-difference"}, n_ranks);
  expect_refused(registering({"--method", "fdm", "--set", "Supports/Lateral chest ratio=0.5"}),
                 {"Lateral chest ratio", "finite differences", "set it to 1"});
}

TEST_F(Run, OutputFolderWithForeignContent) {
  const auto foreign = folder_ / "precious";
  std::filesystem::create_directory(foreign);
  text_file(foreign / "summary.json", "years of work");
  for (const char* command : {"register", "unload", "mesh", "load"})
    expect_refused({command, PROSUP_PRM_FOLDER "/tests/small.prm", "--output", foreign},
                   {"precious", "'summary.json'", "--overwrite", "--output"}, 2);
  EXPECT_EQ(contents(foreign / "summary.json"), "years of work");
  unsigned n_entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(foreign))
    ++n_entries;
  EXPECT_EQ(n_entries, 1u);
}

// The name of an input is that of an output, also through a link.
TEST_F(Run, OutputOverAnInput) {
  const auto place = folder_ / "case";
  std::filesystem::create_directory(place);
  std::filesystem::copy(data_file("small/landmarks.csv"), place / "landmarks.csv");
  std::filesystem::create_symlink(place / "landmarks.csv", folder_ / "link.csv");
  for (const std::filesystem::path& landmarks : {place / "landmarks.csv", folder_ / "link.csv"})
    expect_refused({"register", PROSUP_PRM_FOLDER "/tests/small.prm", "--landmarks", landmarks,
                    "--output", place, "--overwrite"},
                   {"input", "landmarks.csv", "--output"});
  EXPECT_EQ(contents(place / "landmarks.csv"), contents(data_file("small/landmarks.csv")));
}

TEST_F(Run, WritePrmOverAFile) {
  const std::string file = write("mine.prm", "subsection Case\nend\n");
  expect_refused({"register", file, "--write-prm", file, "--overwrite"}, {"mine.prm", "input"});
  expect_refused({"register", "--write-prm", file}, {"mine.prm", "--overwrite"});
  EXPECT_EQ(contents(file), "subsection Case\nend\n");
}

TEST_F(Run, MapOverItsInputOrAForeignFile) {
  const std::string result = folder_ / "result", text = "id,x,y,z\na,1,2,3\n";
  std::filesystem::create_directory(result);
  write("result/summary.json", "{}");
  const std::string in = write("in.csv", text), other = write("other.csv", "patient,age\n");
  const Arguments mapping{"map", "--result", result, "--from", "prone", "--to", "supine", in, "-o"};
  expect_refused(mapping + Arguments{in}, {"in.csv", "input"});
  expect_refused(mapping + Arguments{other}, {"other.csv", "--overwrite"});
  expect_refused(mapping + Arguments{folder_ / "out.nii.gz"}, {"out.nii.gz", "is not known"});
  EXPECT_EQ(contents(in), text);
  EXPECT_EQ(contents(other), "patient,age\n");
}

TEST_F(Run, OutputFolderUnderAFile) {
  const std::string file = write("file", "text");
  for (const std::string& output : {file, file + "/out", file + "/a/b"})
    expect_refused({"register", PROSUP_PRM_FOLDER "/tests/small.prm", "--output", output},
                   {"/file", "--output"});
  EXPECT_EQ(contents(file), "text");
}

TEST_F(Run, MapWithoutARegistration) {
  const std::string file = points("id,x,y,z\na,1,2,3\n");
  for (const unsigned n_ranks : {1u, 2u})
    expect_refused(mapping("nowhere", "prone", "supine", file), {"nowhere", "--output"}, n_ranks);
  expect_refused(mapping(PROSUP_TEST_DATA, "prone", "unloaded", file), {PROSUP_TEST_DATA});
}

TEST_F(Run, MapWithoutARegistrationToTheSameState) {
  const std::string file = points("id,x,y,z\na,1,2,3\n");
  expect_refused(mapping("nowhere", "unloaded", "unloaded", file),
                 {"nowhere", "no finished registration"});
}

TEST_F(Run, MapOfPointsWithoutAColumn) {
  std::filesystem::create_directory(folder_ / "result");
  write("result/summary.json", "{}");
  const std::string result = folder_ / "result";
  expect_refused(mapping(result, "prone", "supine", points("id,x,y\na,1,2\n")),
                 {"points.csv", "column 'z'"});
  expect_refused(mapping(result, "prone", "supine", points("id,x,y,z\na,1,inf,3\n")),
                 {"points.csv", "line 2", "'inf'"});
}

TEST_F(Run, MapToAnUnknownState) {
  expect_refused(mapping("nowhere", "prone", "sitting", points("id,x,y,z\na,1,2,3\n")),
                 {"--to", "sitting", "prone", "supine", "unloaded"});
}

TEST_F(Run, MapWithoutItsOptions) {
  expect_refused({"map", "--from", "prone", "--to", "supine", "points.csv", "-o", output()},
                 {"--result", "required"});
}

TEST_F(Run, NoCommandOrAnUnknownOne) {
  for (const unsigned n_ranks : {1u, 2u})
    expect_refused({}, {"register", "unload", "mesh", "map"}, n_ranks);
  expect_refused({"regster"}, {"regster", "register", "unload", "mesh", "map"});
  expect_refused({"register", "--ouput", output()}, {"--ouput", "--help"});
  expect_refused({"mesh", "--chest", "fixed", "--output", output()},
                 {"'mesh'", "no option '--chest'", "prosup mesh --help"});
  expect_refused({"phantom", "--state", "prone", "--output", output()}, {"'--state'", "phantom"},
                 2);
}

} // namespace
} // namespace prosup::tests
