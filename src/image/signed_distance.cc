#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <algorithm>

#include "itk_bridge.h"
#include "prosup/core/error.h"
#include "prosup/image/filters.h"

namespace prosup::image {

namespace {

/// Distance to the centres of the outermost inside voxels, mm.
ScalarImage distance_to_centres(const LabelImage& mask) {
  using Filter = itk::SignedMaurerDistanceMapImageFilter<ItkImage<std::uint8_t>, ItkImage<float>>;
  const auto view = as_itk(mask);
  auto filter = Filter::New();
  filter->SetInput(view);
  filter->SetBackgroundValue(0);
  filter->SetInsideIsPositive(false);
  filter->SetSquaredDistance(false);
  filter->SetUseImageSpacing(true);
  filter->Update();
  return from_itk<float>(*filter->GetOutput(), mask.grid);
}

} // namespace

ScalarImage signed_distance(const LabelImage& mask) {
  const LabelImage complement = select_labels(mask, {0});
  const auto n_outside = std::count(complement.values.begin(), complement.values.end(), 1);
  if (n_outside == 0 || std::size_t(n_outside) == complement.values.size())
    throw Error("The distance to a mask that is empty or fills its image is not defined; correct "
                "the mask.");
  // The faces lie midway between the outermost voxels of the two sides.
  ScalarImage distance = distance_to_centres(mask);
  const ScalarImage from_outside = distance_to_centres(complement);
  std::transform(distance.values.begin(), distance.values.end(), from_outside.values.begin(),
                 distance.values.begin(), [](float a, float b) { return 0.5f * (a - b); });
  return distance;
}

} // namespace prosup::image
