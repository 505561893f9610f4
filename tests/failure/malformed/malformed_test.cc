#include <gtest/gtest.h>

#include <algorithm>

#include "affine_mesh.h"
#include "command_in_process.h"
#include "mutations.h"
#include "prosup/image/image_io.h"
#include "prosup/output/vtu.h"

namespace prosup::tests {
namespace {

/// Files that are damaged, or that lie: whatever they hold, a command ends with one sentence or
/// with its work done.
class Malformed : public ::testing::Test {
protected:
  void SetUp() override {
    image::VoxelGrid grid;
    grid.size = {12, 10, 8};
    grid.spacing = dealii::Tensor<1, 3>({6., 6., 7.});
    grid.direction = dealii::Tensor<2, 3>({{1., 0., 0.}, {0., 0.8, -0.6}, {0., 0.6, 0.8}});
    labels_ = image::LabelImage(grid);
    for (std::size_t v = 0; v < labels_.values.size(); ++v) {
      const std::size_t j = v / 12 % 10;
      labels_.values[v] = std::uint8_t(j > 6 ? 1 : j > 2 ? 2 + v % 2 : 0);
    }
    image_ = image::ScalarImage(grid);
    for (std::size_t v = 0; v < image_.values.size(); ++v)
      image_.values[v] = float(v * 37 % 1000);
    for (const char* name : {"prone.nii", "prone.nii.gz", "prone.mha", "prone.mhd", "prone.nrrd",
                             "prone.nhdr", "supine.nrrd"})
      image::write_image(image_, folder_ / name);
    for (const char* name : {"prone_labels.nii.gz", "prone_labels.mha", "supine_labels.nrrd"})
      image::write_labels(labels_, folder_ / name);
    text_file(folder_ / "landmarks.csv", "id,prone_x,prone_y,prone_z,supine_x,supine_y,supine_z\n1,"
                                         "1,2,3,4,5,6\n\"a, b\",-1.5,2,3,4,5e0,6\n");
  }

  /// One line on standard error if it fails, and nothing left behind.
  void expect_clear_end(const CommandResult& result, const std::string& what) const {
    EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1) << what;
    if (result.exit_code != 0) {
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << what << "\n"
                                                                           << result.err;
      EXPECT_EQ(result.err.rfind("prosup: ", 0), 0u) << what << "\n" << result.err;
      EXPECT_EQ(result.err[result.err.size() - 2], '.') << what << "\n" << result.err;
    }
    const auto results = folder_ / "results";
    EXPECT_TRUE(!std::filesystem::exists(results) || std::filesystem::is_empty(results)) << what;
  }

  /// Registers with each mutation of the file `name`, given by `option`. The mesh that is asked for
  /// is too coarse, so that what can be read is refused too, before anything is simulated.
  void register_with(const Mutations& mutations, const std::string& option,
                     const std::string& name) {
    for (const Mutation& mutation : mutations) {
      std::vector<std::string> arguments{"register", "--set", "Meshing/Edge length=100", "--output",
                                         folder_ / "results/out"};
      const auto give = [&](const std::string& key, const std::string& file) {
        arguments.insert(arguments.end(), {"--" + key, folder_ / (key == option ? name : file)});
      };
      give("prone-image", "prone.nrrd");
      give("prone-labels", "prone_labels.mha");
      give("supine-image", "supine.nrrd");
      give("supine-labels", "supine_labels.nrrd");
      give("landmarks", "landmarks.csv");
      const std::string before = contents(folder_ / name);
      text_file(folder_ / name, mutation.bytes);
      const CommandResult result = run_in_process(arguments, folder_);
      text_file(folder_ / name, before);
      EXPECT_EQ(result.exit_code, 1) << mutation.what;
      expect_clear_end(result, name + ": " + mutation.what);
      ++n_inputs_;
    }
    std::printf("%s: %zu inputs\n", name.c_str(), mutations.size());
  }

  std::string bytes(const std::string& name) const { return contents(folder_ / name); }

  const TemporaryFolder folder_;
  image::LabelImage labels_;
  image::ScalarImage image_;
  unsigned n_inputs_ = 0;
};

/// Each number of a NIfTI-1 header, by the offsets of its standard.
Mutations nifti_fields(const std::string& whole) {
  Mutations result = extreme<std::int32_t>(whole, 0);
  for (const std::size_t at : {40, 42, 44, 46, 48, 68, 70, 72, 74, 252, 254})
    result = result + extreme<std::int16_t>(whole, at);
  for (const std::size_t at : {76, 80, 84, 88, 108, 112, 116, 256, 268, 280, 300, 324})
    result = result + extreme<float>(whole, at);
  for (const std::size_t at : {123, 344})
    result = result + extreme<std::int8_t>(whole, at);
  return result;
}

TEST_F(Malformed, Nifti) {
  const std::string whole = bytes("prone.nii");
  register_with(nifti_fields(whole) + truncated(whole, 12), "prone-image", "prone.nii");
}

TEST_F(Malformed, CompressedNifti) {
  const std::string whole = bytes("prone_labels.nii.gz");
  register_with(truncated(whole, 16) + damaged(whole, 0, whole.size(), 40), "prone-labels",
                "prone_labels.nii.gz");
}

TEST_F(Malformed, MetaImage) {
  const std::string whole = bytes("prone.mha");
  const std::size_t end = whole.find("LOCAL") + 6;
  register_with(changed_lines(whole, end, " = ") + truncated(whole, 16), "prone-image",
                "prone.mha");
}

TEST_F(Malformed, MetaImageWithItsDataApart) {
  const std::string whole = bytes("prone.mhd");
  register_with(changed_lines(whole, whole.size(), " = "), "prone-image", "prone.mhd");
}

TEST_F(Malformed, Nrrd) {
  const std::string whole = bytes("supine_labels.nrrd");
  const std::size_t end = whole.find("\n\n") + 1;
  register_with(changed_lines(whole, end, ": ") + truncated(whole, 16) +
                    damaged(whole, end, whole.size(), 16),
                "supine-labels", "supine_labels.nrrd");
}

TEST_F(Malformed, NrrdWithItsDataApart) {
  const std::string whole = bytes("prone.nhdr");
  register_with(changed_lines(whole, whole.size(), ": "), "prone-image", "prone.nhdr");
}

TEST_F(Malformed, Landmarks) {
  const std::string whole = bytes("landmarks.csv");
  register_with(truncated(whole, 20) + changed_lines(whole, whole.size(), ",") +
                    damaged(whole, 0, whole.size(), 40),
                "landmarks", "landmarks.csv");
}

/// Maps points with a result whose meshes are two stretched boxes.
class MalformedMap : public Malformed {
protected:
  void SetUp() override {
    Malformed::SetUp();
    result_ = folder_ / "result";
    std::filesystem::create_directory(result_);
    const mesh::TetMesh box = box_of_tets({-20., -20., -20.}, {20., 20., 20.}, 2);
    output::write_mesh(affine_mesh(box, stretch_and_shear()), result_, "prone");
    output::write_mesh(affine_mesh(box, other_stretch_and_shear()), result_, "supine");
    text_file(result_ / "summary.json", "{\"version\": \"0.1.0\"}\n");
    text_file(folder_ / "points.csv", "id,x,y,z\n1,1,2,3\n2,-4,5.5,6e0\n");
    text_file(folder_ / "points.fcsv",
              "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n# columns = "
              "id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
              "n_0,-1.5,2,3,0,0,0,1,1,1,0,F-1,,\n");
    text_file(folder_ / "points.mrk.json",
              "{\"markups\": [{\n\"type\": \"Fiducial\",\n\"coordinateSystem\": \"LPS\",\n"
              "\"coordinateUnits\": \"mm\",\n\"controlPoints\": [{\n\"label\": \"F-1\",\n"
              "\"position\": [1, 2.5, 3],\n\"positionStatus\": \"defined\"\n}]\n}]}\n");
  }

  void map_with(const Mutations& mutations, const std::filesystem::path& changed,
                const std::string& points) {
    const std::string before = contents(changed);
    for (const Mutation& mutation : mutations) {
      text_file(changed, mutation.bytes);
      const CommandResult result =
          run_in_process({"map", "--result", result_, "--from", "prone", "--to", "supine",
                          folder_ / points, "--output", folder_ / "mapped.csv"},
                         folder_);
      expect_clear_end(result, changed.filename().string() + ": " + mutation.what);
      EXPECT_EQ(std::filesystem::exists(folder_ / "mapped.csv"), result.exit_code == 0);
      EXPECT_EQ(contents(folder_ / "mapped.csv").find("nan"), std::string::npos) << mutation.what;
      std::filesystem::remove(folder_ / "mapped.csv");
    }
    text_file(changed, before);
    std::printf("%s: %zu inputs\n", changed.filename().c_str(), mutations.size());
  }

  std::filesystem::path result_;
};

TEST_F(MalformedMap, Points) {
  for (const std::string name : {"points.csv", "points.fcsv", "points.mrk.json"}) {
    const std::string whole = bytes(name);
    map_with(truncated(whole, 16) + damaged(whole, 0, whole.size(), 40) +
                 changed_lines(whole, whole.size(), name == "points.mrk.json" ? ": " : ","),
             folder_ / name, name);
  }
}

TEST_F(MalformedMap, Meshes) {
  const auto mesh = result_ / "prone_loaded.vtu";
  const std::string whole = contents(mesh);
  map_with(truncated(whole, 12) + damaged(whole, 0, whole.size(), 60) +
               changed_lines(whole, whole.size(), "=\""),
           mesh, "points.csv");
}

/// Parameter files that are cut off, damaged, or say something else.
TEST_F(Malformed, Parameters) {
  const std::string whole = "subsection Meshing\n  set Edge length = 100\nend\nsubsection Case\n"
                            "  set Prone gravity = 0, -1, 0\n  set Chest = sliding\nend\n"
                            "subsection Labels\n  set Tissues = 2, 3\nend\n";
  const auto file = folder_ / "case.prm";
  const Mutations all = truncated(whole, 20) + damaged(whole, 0, whole.size(), 40) +
                        changed_lines(whole, whole.size(), " = ");
  for (const Mutation& mutation : all) {
    text_file(file, mutation.bytes);
    const CommandResult result =
        run_in_process({"register", file, "--output", folder_ / "results/out"}, folder_);
    EXPECT_EQ(result.exit_code, 1) << mutation.what; // no image is given
    expect_clear_end(result, mutation.what);
  }
}

TEST_F(Malformed, ParameterFilesThatIncludeEachOther) {
  text_file(folder_ / "a.prm", "include " + (folder_ / "b.prm").string() + "\n");
  text_file(folder_ / "b.prm", "include " + (folder_ / "a.prm").string() + "\n");
  const CommandResult result =
      run_in_process({"register", folder_ / "a.prm", "--output", folder_ / "results/out"}, folder_);
  expect_clear_end(result, "a.prm");
  EXPECT_NE(result.err.find("b.prm' includes"), std::string::npos) << result.err;
}

} // namespace
} // namespace prosup::tests
