#include "prosup/output/surface_model.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkOBJWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSTLWriter.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <fstream>

#include "prosup/core/error.h"
#include "prosup/core/text.h"
#include "prosup/core/text_file.h"
#include "vtk_errors.h"

namespace prosup::output {

namespace fs = std::filesystem;

namespace {

using Model = vtkSmartPointer<vtkPolyData>;

std::string ending_of(const fs::path& file) {
  return lower_case(file.extension().string());
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw Error("The model '" + file.string() + "' " + why +
              "; give a surface as .vtp, .stl or .obj, whole and in mm.");
}

template <typename Reader>
Model read_with(const fs::path& file) {
  const QuietVtk quiet;
  vtkNew<Reader> reader;
  vtkNew<VtkErrors> errors;
  errors->listen_to(*reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (errors->any() || reader->GetOutput() == nullptr ||
      reader->GetOutput()->GetNumberOfPoints() == 0)
    refuse(file, "cannot be read or has no points");
  return reader->GetOutput();
}

Model read(const fs::path& file) {
  if (!fs::is_regular_file(file))
    refuse(file, "does not exist");
  if (ending_of(file) == ".vtp")
    return read_with<vtkXMLPolyDataReader>(file);
  return ending_of(file) == ".stl" ? read_with<vtkSTLReader>(file) : read_with<vtkOBJReader>(file);
}

constexpr const char* space_array = "SPACE"; // of 3D Slicer

/// 3D Slicer notes the space in the first line of STL and OBJ, and in an array of VTP.
bool is_ras(const fs::path& file, vtkPolyData& model) {
  auto* space = vtkStringArray::SafeDownCast(model.GetFieldData()->GetAbstractArray(space_array));
  if (space != nullptr && space->GetNumberOfValues() > 0)
    return space->GetValue(0) == "RAS";
  std::string beginning(200, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return ending_of(file) != ".vtp" && beginning.find("SPACE=RAS") != std::string::npos;
}

void write_vtp(vtkPolyData& model, const fs::path& file) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  vtkNew<VtkErrors> errors;
  errors->listen_to(*writer);
  writer->WriteToOutputStringOn(); // VTK does not notice that a disk is full
  writer->SetInputData(&model);
  if (writer->Write() == 0 || errors->any())
    throw_cannot_write(file);
  write_text_file(writer->GetOutputString(), file);
}

/// These writers know only files, which are read back to see whether they are whole.
template <typename Writer>
void write_with(Writer& writer, vtkPolyData& model, const fs::path& file) {
  const QuietVtk quiet;
  vtkNew<VtkErrors> errors;
  errors->listen_to(writer);
  writer.SetFileName(file.c_str());
  writer.SetInputData(&model);
  writer.Write();
  if (errors->any() || writer.GetErrorCode() != 0 ||
      read(file)->GetNumberOfPolys() < model.GetNumberOfPolys())
    throw_cannot_write(file);
}

void write(vtkPolyData& model, const fs::path& file) {
  if (ending_of(file) == ".vtp")
    return write_vtp(model, file);
  if (model.GetNumberOfPolys() + model.GetNumberOfStrips() == 0)
    throw Error("The model has no faces, without which it cannot be written as " + ending_of(file) +
                "; write it as .vtp.");
  if (ending_of(file) == ".obj") {
    vtkNew<vtkOBJWriter> writer;
    return write_with(*writer, model, file);
  }
  vtkNew<vtkSTLWriter> writer;
  writer->SetFileTypeToBinary();
  writer->SetHeader("prosup SPACE=LPS");
  write_with(*writer, model, file);
}

} // namespace

bool is_model(const fs::path& file) {
  const std::string ending = ending_of(file);
  return ending == ".vtp" || ending == ".stl" || ending == ".obj";
}

std::size_t move_model(const fs::path& from, const fs::path& to,
                       const std::function<dealii::Point<3>(const dealii::Point<3>&)>& map) {
  const Model model = read(from);
  const double turn = is_ras(from, *model) ? -1. : 1.;
  vtkPoints& points = *model->GetPoints();
  for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i) {
    double p[3];
    points.GetPoint(i, p);
    const dealii::Point<3> moved = map({turn * p[0], turn * p[1], p[2]});
    if (!std::isfinite(moved[0] + moved[1] + moved[2]))
      refuse(from, "has a point that cannot be mapped");
    points.SetPoint(i, moved[0], moved[1], moved[2]);
  }
  model->GetPointData()->SetNormals(nullptr);
  model->GetCellData()->SetNormals(nullptr);
  if (model->GetFieldData()->HasArray(space_array) != 0) {
    vtkNew<vtkStringArray> space;
    space->SetName(space_array);
    space->InsertNextValue("LPS");
    model->GetFieldData()->RemoveArray(space_array);
    model->GetFieldData()->AddArray(space);
  }
  write(*model, to);
  return static_cast<std::size_t>(points.GetNumberOfPoints());
}

} // namespace prosup::output
