#include "prosup/output/registration_file.h"

#include <gtest/gtest.h>
#include <mpi.h>

#include <limits>
#include <regex>

#include "affine_mesh.h"
#include "expect_error.h"
#include "prosup/output/hdf5_file.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::output;

PerPosition<mesh::UnloadedMesh> irrational_meshes() {
  PerPosition<mesh::UnloadedMesh> meshes{
      affine_mesh(box_of_tets({-1. / 3., 1. / 7., 100. / 3.}, {20.1, 30.3, 70.7}, 4),
                  stretch_and_shear()),
      affine_mesh(box_of_tets({-1. / 3., 1. / 7., 100. / 3.}, {20.1, 30.3, 70.7}, 3),
                  other_stretch_and_shear())};
  for (const Position position : both_positions) {
    mesh::TetMesh& mesh = meshes[position].mesh;
    const auto& c = mesh.cells[0];
    mesh.boundary_faces = {{{c[0], c[2], c[1]}, mesh::BoundaryPart::skin},
                           {{c[0], c[1], c[3]}, mesh::BoundaryPart::chest_wall}};
  }
  return meshes;
}

// Bitwise, as from the VTU files.
TEST(RegistrationFile, RoundTripIsExact) {
  const TemporaryFolder folder;
  const auto meshes = irrational_meshes();
  write_registration(meshes, {{"shear_modulus", 1000. / 3.}}, folder / "");
  for (const Position position : both_positions) {
    const auto read = read_registration(folder / registration_h5, position);
    const auto& written = meshes[position];
    EXPECT_EQ(read.mesh.points, written.mesh.points);
    EXPECT_EQ(read.unloaded, written.unloaded);
    EXPECT_EQ(read.mesh.cells, written.mesh.cells);
    EXPECT_EQ(read.mesh.tissue, written.mesh.tissue);
    ASSERT_EQ(read.mesh.boundary_faces.size(), 2u);
    for (unsigned f = 0; f < 2; ++f) {
      EXPECT_EQ(read.mesh.boundary_faces[f].nodes, written.mesh.boundary_faces[f].nodes);
      EXPECT_EQ(read.mesh.boundary_faces[f].part, written.mesh.boundary_faces[f].part);
    }
  }
  const Hdf5Reader file(folder / registration_h5, "registration", MPI_COMM_SELF, "-");
  EXPECT_EQ(file.number("properties/shear_modulus"), 1000. / 3.);
  EXPECT_FALSE(file.text("version").empty());
}

TEST(RegistrationFile, KeepsTheAlignmentOfTheChests) {
  const TemporaryFolder folder;
  image::RigidTransform alignment;
  alignment.rotation = image::rotation_about(dealii::Tensor<1, 3>({0.1, -0.2, 0.05}));
  alignment.centre = dealii::Point<3>(10., 20., 30.);
  alignment.translation = dealii::Tensor<1, 3>({1., 2., 3.});
  write_registration(irrational_meshes(), {}, folder / "", {}, alignment);
  const dealii::Point<3> x(-5., 7., 11.);
  EXPECT_LT(read_alignment(folder / registration_h5).value()(x).distance(alignment(x)), 1e-12);
}

TEST(RegistrationFile, KeepsTheCovariancesIfThereAreAny) {
  const TemporaryFolder folder;
  const auto meshes = irrational_meshes();
  write_registration(meshes, {}, folder / "");
  EXPECT_FALSE(read_covariances(folder / registration_h5));
  evaluation::Uncertainty::Covariances covariances;
  for (const Position position : both_positions)
    for (std::size_t node = 0; node < meshes[position].unloaded.size(); ++node) {
      evaluation::Covariance& covariance = covariances[position].emplace_back();
      for (unsigned i = 0; i < 6; ++i)
        covariance.access_raw_entry(i) = 1. / (1. + double(node) + i);
    }
  write_registration(meshes, {}, folder / "", covariances);
  const auto read = read_covariances(folder / registration_h5);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->prone, covariances.prone);
  EXPECT_EQ(read->supine, covariances.supine);
}

// What ParaView reads is there, and has the numbers of rows and columns that the XDMF file tells.
TEST(RegistrationFile, XdmfNamesDataSetsOfTheRightSizes) {
  const TemporaryFolder folder;
  write_registration(irrational_meshes(), {}, folder / "");
  const std::string text = contents(folder / registration_xdmf);
  const Hdf5Reader file(folder / registration_h5, "registration", MPI_COMM_SELF, "-");
  const std::regex item("<DataItem Dimensions=\"(\\d+) ?(\\d*)\" NumberType=\"(\\w+)\" "
                        "Precision=\"(\\d)\" Format=\"HDF\">registration.h5:/([^<]*)</DataItem>");
  unsigned n_items = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), item), end; i != end; ++i, ++n_items) {
    const std::smatch& match = *i;
    const std::size_t size =
        std::stoul(match[1]) * (match[2].length() > 0 ? std::stoul(match[2]) : 1);
    EXPECT_EQ(file.doubles(match[5]).size(), size) << match[5];
    EXPECT_EQ(match[4], match[3] == "Float" ? "8" : "4");
  }
  // For each of two steps and two breasts: cells with five data sets, and faces with four.
  EXPECT_EQ(n_items, 2u * 2u * 9u);
  EXPECT_EQ(std::distance(text.begin(), std::find(text.begin(), text.end(), '<')), 0);
  const auto count = [&](const std::string& word) {
    unsigned n = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
      ++n;
    return n;
  };
  for (const char* name :
       {"Xdmf", "Domain", "Grid", "Topology", "Geometry", "Attribute", "DataItem"})
    EXPECT_EQ(count(std::string("<") + name + " ") + count(std::string("<") + name + ">"),
              count(std::string("</") + name + ">"))
        << name;
}

TEST(RegistrationFile, RefusesWhatCannotBeRight) {
  const TemporaryFolder folder;
  auto meshes = irrational_meshes();
  expect_error([&] { write_registration(meshes, {}, folder / "missing"); },
               {"registration.h5", "cannot be written"});
  expect_error(
      [&] {
        write_registration(meshes, {{"a", std::numeric_limits<double>::infinity()}}, folder / "");
      },
      {"'a'", "not a finite"});
  meshes.supine.unloaded[7][2] = std::numeric_limits<double>::quiet_NaN();
  expect_error([&] { write_registration(meshes, {}, folder / ""); },
               {"Node 7", "'supine'", "not a finite"});
  EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
  expect_error([&] { read_registration(text_file(folder / "bad.h5", "no mesh"), Position::prone); },
               {"bad.h5", "damaged", "result folder"});
}

} // namespace
} // namespace prosup::tests
