#include "boxes.h"

// A macro of deal.II, which the precompiled header brings, and a function of ITK's statistics.
#undef Assert

#include <itkFlatStructuringElement.h>
#include <itkGrayscaleDilateImageFilter.h>
#include <itkGrayscaleErodeImageFilter.h>

#include <cmath>

#include "image/itk_bridge.h"
#include "prosup/image/filters.h"

namespace prosup::prepare {

namespace {

using image::LabelImage;
using image::ScalarImage;
using Box = itk::FlatStructuringElement<3>;

Box box(const image::VoxelGrid& grid, double radius) {
  Box::RadiusType n_voxels;
  for (unsigned d = 0; d < 3; ++d)
    n_voxels[d] = static_cast<unsigned long>(std::lround(radius / grid.spacing[d]));
  return Box::Box(n_voxels);
}

LabelImage inverse(const LabelImage& mask) {
  return image::select_labels(mask, {0});
}

} // namespace

ScalarImage local_peak(const ScalarImage& image, double radius) {
  using Itk = image::ItkImage<float>;
  auto dilate = itk::GrayscaleDilateImageFilter<Itk, Itk, Box>::New();
  dilate->SetInput(image::as_itk(image));
  dilate->SetKernel(box(image.grid, radius));
  dilate->Update();
  return image::from_itk<float>(*dilate->GetOutput(), image.grid);
}

LabelImage eroded(const LabelImage& mask, double radius) {
  using Image = image::ItkImage<std::uint8_t>;
  auto erode = itk::GrayscaleErodeImageFilter<Image, Image, Box>::New();
  erode->SetInput(image::as_itk(mask));
  erode->SetKernel(box(mask.grid, radius));
  erode->Update();
  return image::from_itk<std::uint8_t>(*erode->GetOutput(), mask.grid);
}

LabelImage closed(const LabelImage& mask, double radius) {
  return eroded(inverse(eroded(inverse(mask), radius)), radius);
}

LabelImage opened(const LabelImage& mask, double radius) {
  return inverse(eroded(inverse(eroded(mask, radius)), radius));
}

} // namespace prosup::prepare
