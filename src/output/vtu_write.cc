#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "mesh_checks.h"
#include "prosup/core/text_file.h"
#include "prosup/mesh/boundary_codes.h"
#include "prosup/mesh/quality.h"
#include "prosup/output/vtu.h"
#include "vtk_errors.h"

namespace prosup::output {

namespace {

using dealii::Point;
using mesh::UnloadedMesh;

void add_vectors(vtkUnstructuredGrid& grid, const char* name, const std::vector<Point<3>>& ends,
                 const std::vector<Point<3>>* starts = nullptr) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(ends.size()));
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (unsigned d = 0; d < 3; ++d)
      array->SetTypedComponent(static_cast<vtkIdType>(i), static_cast<int>(d),
                               ends[i][d] - (starts ? (*starts)[i][d] : 0.));
  grid.GetPointData()->AddArray(array);
}

/// `nodes` are those of the configuration whose shapes the quality is of.
void add_cell_data(vtkUnstructuredGrid& grid, const UnloadedMesh& mesh,
                   const std::vector<Point<3>>& nodes, const std::string& name) {
  vtkNew<vtkUnsignedCharArray> tissue, boundary;
  tissue->SetName("tissue");
  boundary->SetName("boundary");
  for (const std::uint8_t code : mesh::boundary_codes(mesh.mesh))
    boundary->InsertNextValue(code);
  vtkNew<vtkDoubleArray> jacobian, quality;
  jacobian->SetName("J");
  quality->SetName("quality");
  const std::vector<double> jacobians = checked_jacobians(mesh, name);
  for (std::size_t cell = 0; cell < mesh.mesh.cells.size(); ++cell) {
    const auto& c = mesh.mesh.cells[cell];
    tissue->InsertNextValue(mesh.mesh.tissue[cell]);
    jacobian->InsertNextValue(jacobians[cell]);
    quality->InsertNextValue(
        mesh::radius_ratio({nodes[c[0]], nodes[c[1]], nodes[c[2]], nodes[c[3]]}));
  }
  grid.GetCellData()->AddArray(tissue);
  grid.GetCellData()->AddArray(boundary);
  grid.GetCellData()->AddArray(jacobian);
  grid.GetCellData()->AddArray(quality);
}

vtkSmartPointer<vtkUnstructuredGrid> make_grid(const std::vector<Point<3>>& nodes,
                                               const mesh::TetMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point<3>& p : nodes)
    points->InsertNextPoint(p[0], p[1], p[2]);
  vtkNew<vtkCellArray> cells;
  for (const auto& c : mesh.cells)
    cells->InsertNextCell({c[0], c[1], c[2], c[3]});
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(VTK_TETRA, cells);
  return grid;
}

void write_vtu(vtkUnstructuredGrid* grid, const std::filesystem::path& file) {
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  vtkNew<VtkErrors> errors;
  errors->listen_to(*writer);
  // VTK does not notice that a disk is full.
  writer->WriteToOutputStringOn();
  writer->SetInputData(grid);
  if (writer->Write() == 0 || errors->any())
    throw_cannot_write(file);
  write_text_file(writer->GetOutputString(), file);
}

void write_pvd(const std::filesystem::path& folder, const std::string& name) {
  write_text_file("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                  "  <Collection>\n"
                  "    <DataSet timestep=\"0\" file=\"" +
                      name +
                      "_unloaded.vtu\"/>\n"
                      "    <DataSet timestep=\"1\" file=\"" +
                      name +
                      "_loaded.vtu\"/>\n"
                      "  </Collection>\n</VTKFile>\n",
                  folder / (name + ".pvd"));
}

} // namespace

void write_mesh(const UnloadedMesh& mesh, const std::filesystem::path& folder,
                const std::string& name) {
  check_mesh(mesh, name);
  const auto& loaded_nodes = mesh.mesh.points;
  const auto loaded = make_grid(loaded_nodes, mesh.mesh);
  add_vectors(*loaded, "displacement", loaded_nodes, &mesh.unloaded);
  add_vectors(*loaded, "unloaded", mesh.unloaded);
  add_cell_data(*loaded, mesh, loaded_nodes, name);
  const auto unloaded = make_grid(mesh.unloaded, mesh.mesh);
  add_vectors(*unloaded, "displacement", loaded_nodes, &mesh.unloaded);
  add_vectors(*unloaded, "loaded", loaded_nodes);
  add_cell_data(*unloaded, mesh, mesh.unloaded, name);
  write_vtu(loaded, folder / (name + "_loaded.vtu"));
  write_vtu(unloaded, folder / (name + "_unloaded.vtu"));
  write_pvd(folder, name);
}

} // namespace prosup::output
