#include <gmsh.h>

#include <gtest/gtest.h>

#include "prosup/mesh/mask_mesher.h"
#include "test_labels.h"

namespace prosup::tests {
namespace {

using namespace prosup::mesh;

// A program that uses gmsh itself finds its model, its options and gmsh still there.
TEST(GmshHost, KeepsItsModelAndOptions) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Verbosity", 1.);
  gmsh::option::setNumber("Mesh.MeshSizeMax", 123.);
  gmsh::option::setNumber("Mesh.Algorithm3D", 4.);
  gmsh::model::add("host");
  gmsh::model::geo::addPoint(1., 2., 3., 0., 42);
  gmsh::model::geo::synchronize();

  const Labels label_values;
  MaskMesher mesher(label_values);
  mesher.edge_length = 8.;
  EXPECT_GT(mesher.mesh(ball_labels(centred_cube(30), 12.)).cells.size(), 0u);

  std::string model;
  gmsh::model::getCurrent(model);
  EXPECT_EQ(model, "host");
  std::vector<std::string> models;
  gmsh::model::list(models);
  EXPECT_EQ(std::count(models.begin(), models.end(), "prosup mask mesh"), 0);
  std::vector<std::pair<int, int>> points;
  gmsh::model::getEntities(points, 0);
  EXPECT_EQ(points, (std::vector<std::pair<int, int>>{{0, 42}}));
  for (const auto& [option, expected] :
       {std::pair{"General.Verbosity", 1.}, std::pair{"Mesh.MeshSizeMax", 123.},
        std::pair{"Mesh.Algorithm3D", 4.}}) {
    double value = 0.;
    gmsh::option::getNumber(option, value);
    EXPECT_EQ(value, expected) << option;
  }
  gmsh::finalize();
}

} // namespace
} // namespace prosup::tests
