#include "canvas.h"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

#include "prosup/core/text_file.h"
#include "vtk_errors.h"

namespace prosup::output {

Canvas::Canvas(int width, int height, const Colour& background)
    : width_(width), height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background) {}

void Canvas::set(int x, int y, const Colour& colour) {
  blend(x, y, colour, 1.);
}

void Canvas::blend(int x, int y, const Colour& colour, double opacity) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_)
    return;
  Colour& pixel = pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                          static_cast<std::size_t>(x)];
  for (unsigned c = 0; c < 3; ++c)
    pixel[c] =
        static_cast<std::uint8_t>(std::lround(opacity * colour[c] + (1. - opacity) * pixel[c]));
}

void Canvas::text(int x, int y, const std::string& text, int font_size, const Colour& colour) {
  vtkNew<vtkTextProperty> property;
  property->SetFontFamilyToArial();
  property->SetFontSize(font_size);
  vtkNew<vtkImageData> rendered;
  int size[2] = {0, 0};
  constexpr int dots_per_inch = 72;
  // The text explains a picture that is complete without it: where the fonts
  // fail, there is no text.
  if (!vtkFreeTypeTools::GetInstance()->RenderString(property, text, dots_per_inch, rendered,
                                                     size) ||
      rendered->GetNumberOfScalarComponents() != 4)
    return;
  int extent[6];
  rendered->GetExtent(extent);
  for (int row = 0; row < size[1]; ++row)
    for (int column = 0; column < size[0]; ++column) {
      const auto* rgba = static_cast<const unsigned char*>(
          rendered->GetScalarPointer(extent[0] + column, extent[2] + row, extent[4]));
      blend(x - size[0] / 2 + column, y + size[1] / 2 - row, colour, rgba[3] / 255.);
    }
}

std::string Canvas::png() const {
  vtkNew<vtkImageData> image;
  image->SetDimensions(width_, height_, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* target = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = height_ - 1; y >= 0; --y) // VTK's first row is the lowest
    for (int x = 0; x < width_; ++x)
      for (const std::uint8_t component :
           pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)])
        *target++ = component;
  vtkNew<vtkPNGWriter> writer;
  vtkNew<VtkErrors> errors;
  errors->listen_to(*writer);
  writer->WriteToMemoryOn(); // VTK does not notice that a disk is full
  writer->SetInputData(image);
  writer->Write();
  if (errors->any() || writer->GetErrorCode() != 0)
    return {};
  vtkUnsignedCharArray& bytes = *writer->GetResult();
  return std::string(bytes.Begin(), bytes.End());
}

void Canvas::write_png(const std::filesystem::path& file) const {
  const std::string bytes = png();
  if (bytes.empty())
    throw_cannot_write(file);
  write_text_file(bytes, file);
}

} // namespace prosup::output
