#include "smoothing.h"

#include <itkDiscreteGaussianImageFilter.h>
#include <itkRecursiveGaussianImageFilter.h>

#include <cmath>

#include "itk_bridge.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/filters.h"

namespace prosup::image {

namespace {

using Itk = ItkImage<float>;

Itk::Pointer recursive(const Itk* image, unsigned axis, double sigma_mm) {
  auto filter = itk::RecursiveGaussianImageFilter<Itk, Itk>::New();
  filter->SetInput(image);
  filter->SetDirection(axis);
  filter->SetSigma(sigma_mm);
  filter->Update();
  return filter->GetOutput();
}

Itk::Pointer discrete(const Itk* image, unsigned axis, double sigma_mm) {
  auto filter = itk::DiscreteGaussianImageFilter<Itk, Itk>::New();
  double variance[3] = {0., 0., 0.};
  variance[axis] = sigma_mm * sigma_mm;
  filter->SetInput(image);
  filter->SetVariance(variance);
  filter->SetMaximumError(1e-3);
  filter->SetMaximumKernelWidth(256);
  filter->SetUseImageSpacing(true);
  filter->Update();
  return filter->GetOutput();
}

} // namespace

ScalarImage smooth_along_axes(const ScalarImage& image, const Tensor<1, 3>& sigma_mm) {
  Itk::Pointer smoothed = as_itk(image);
  for (unsigned axis = 0; axis < 3; ++axis) {
    // One voxel has no neighbours to be smoothed with.
    if (sigma_mm[axis] == 0. || image.grid.size[axis] == 1)
      continue;
    // The recursive filter costs the same for every width, but it needs four
    // voxels, and its approximation fails for narrow kernels.
    const bool narrow = sigma_mm[axis] < 0.7 * image.grid.spacing[axis];
    smoothed = narrow || image.grid.size[axis] < 4 ? discrete(smoothed, axis, sigma_mm[axis])
                                                   : recursive(smoothed, axis, sigma_mm[axis]);
  }
  return from_itk<float>(*smoothed, image.grid);
}

ScalarImage gaussian_smooth(const ScalarImage& image, double sigma_mm) {
  if (!(sigma_mm >= 0.) || !std::isfinite(sigma_mm))
    throw Error(
        format("The width of a Gaussian is %g mm, but must be zero or positive.", sigma_mm));
  return smooth_along_axes(image, Tensor<1, 3>({sigma_mm, sigma_mm, sigma_mm}));
}

} // namespace prosup::image
