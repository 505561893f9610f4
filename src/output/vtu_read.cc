#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <fstream>
#include <set>

#include "prosup/core/error.h"
#include "prosup/mesh/boundary_codes.h"
#include "prosup/output/vtu.h"
#include "vtk_errors.h"

namespace prosup::output {

namespace {

using dealii::Point;

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw Error("The mesh file '" + file.string() + "' " + why +
              "; give the result folder of a registration that finished.");
}

/// Whether two arrays of the file have one name, at which VTK's reader ends the program.
bool has_array_twice(const std::filesystem::path& file) {
  const std::string attribute = " Name=\"";
  std::ifstream stream(file, std::ios::binary);
  std::set<std::string> names;
  for (std::string line; std::getline(stream, line) && line.find("<AppendedData") == line.npos;)
    if (const std::size_t begin = line.find(attribute); begin != line.npos) {
      const std::size_t name = begin + attribute.size();
      if (!names.insert(line.substr(name, line.find('"', name) - name)).second)
        return true;
    }
  return false;
}

vtkSmartPointer<vtkUnstructuredGrid> read_grid(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file))
    refuse(file, "does not exist");
  if (has_array_twice(file))
    refuse(file, "is damaged: it has an array twice");
  const QuietVtk quiet;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  vtkNew<VtkErrors> errors;
  errors->listen_to(*reader);
  reader->SetReaderErrorObserver(errors);
  reader->SetParserErrorObserver(errors);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (errors->any() || reader->GetOutput() == nullptr ||
      reader->GetOutput()->GetNumberOfCells() == 0)
    refuse(file, "is damaged or is no unstructured mesh");
  return reader->GetOutput();
}

std::vector<Point<3>> points_of(vtkDataArray* array, vtkIdType n,
                                const std::filesystem::path& file) {
  if (array == nullptr || array->GetNumberOfComponents() != 3 || array->GetNumberOfTuples() != n)
    refuse(file, "has no point data 'unloaded' with three components");
  std::vector<Point<3>> points;
  for (vtkIdType i = 0; i < n; ++i) {
    Point<3> p;
    for (unsigned d = 0; d < 3; ++d)
      p[d] = array->GetComponent(i, static_cast<int>(d));
    if (!std::isfinite(p[0] + p[1] + p[2]))
      refuse(file, "has a node position that is not a finite number");
    points.push_back(p);
  }
  return points;
}

/// A small number for each cell.
std::vector<std::uint8_t> cell_numbers(vtkUnstructuredGrid& grid, const char* name,
                                       const std::filesystem::path& file) {
  vtkDataArray* array = grid.GetCellData()->GetArray(name);
  if (array == nullptr || array->GetNumberOfComponents() != 1)
    refuse(file, std::string("has no cell data '") + name + "'");
  std::vector<std::uint8_t> numbers;
  for (vtkIdType cell = 0; cell < array->GetNumberOfTuples(); ++cell)
    numbers.push_back(static_cast<std::uint8_t>(array->GetComponent(cell, 0)));
  return numbers;
}

} // namespace

mesh::UnloadedMesh read_mesh(const std::filesystem::path& loaded_vtu) {
  const auto grid = read_grid(loaded_vtu);
  const vtkIdType n_points = grid->GetNumberOfPoints(), n_cells = grid->GetNumberOfCells();
  mesh::UnloadedMesh result;
  result.mesh.points = points_of(grid->GetPoints()->GetData(), n_points, loaded_vtu);
  result.unloaded = points_of(grid->GetPointData()->GetArray("unloaded"), n_points, loaded_vtu);
  result.mesh.tissue = cell_numbers(*grid, "tissue", loaded_vtu);
  for (vtkIdType cell = 0; cell < n_cells; ++cell) {
    vtkIdType n = 0;
    const vtkIdType* corners = nullptr;
    grid->GetCellPoints(cell, n, corners);
    if (n != 4 || grid->GetCellType(cell) != VTK_TETRA)
      refuse(loaded_vtu, "holds a cell that is no tetrahedron");
    result.mesh.cells.push_back({});
    for (unsigned a = 0; a < 4; ++a)
      result.mesh.cells.back()[a] = static_cast<unsigned>(corners[a]);
  }
  result.mesh.boundary_faces =
      mesh::boundary_faces(result.mesh, cell_numbers(*grid, "boundary", loaded_vtu));
  return result;
}

} // namespace prosup::output
