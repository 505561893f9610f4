#include <itkConnectedComponentImageFilter.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "itk_bridge.h"
#include "prosup/image/filters.h"

namespace prosup::image {

namespace {

using ComponentImage = VoxelImage<std::uint32_t>;

/// Numbers the connected parts of a mask from 1; 0 is outside.
ComponentImage connected_components(const LabelImage& mask) {
  using Filter =
      itk::ConnectedComponentImageFilter<ItkImage<std::uint8_t>, ItkImage<std::uint32_t>>;
  const auto view = as_itk(mask);
  auto filter = Filter::New();
  filter->SetInput(view);
  filter->Update();
  return from_itk<std::uint32_t>(*filter->GetOutput(), mask.grid);
}

std::uint32_t n_components(const ComponentImage& components) {
  return components.values.empty()
             ? 0
             : *std::max_element(components.values.begin(), components.values.end());
}

/// Voxels of each component; of what is outside at 0.
std::vector<std::size_t> sizes_of(const ComponentImage& components) {
  std::vector<std::size_t> n_voxels(n_components(components) + 1, 0);
  for (const std::uint32_t component : components.values)
    ++n_voxels[component];
  return n_voxels;
}

/// Tells for each component whether it reaches the border of the image.
std::vector<bool> reaches_border(const ComponentImage& components) {
  std::vector<bool> reaches(n_components(components) + 1, false);
  const auto& size = components.grid.size;
  const auto on_border = [&](std::size_t i, unsigned d) { return i == 0 || i + 1 == size[d]; };
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i)
        if (on_border(i, 0) || on_border(j, 1) || on_border(k, 2))
          reaches[components(i, j, k)] = true;
  return reaches;
}

} // namespace

LabelImage select_labels(const LabelImage& image, const std::vector<unsigned>& labels) {
  std::array<std::uint8_t, 256> selected{};
  for (const unsigned label : labels)
    if (label < selected.size())
      selected[label] = 1;
  LabelImage mask(image.grid);
  std::transform(image.values.begin(), image.values.end(), mask.values.begin(),
                 [&](std::uint8_t label) { return selected[label]; });
  return mask;
}

LabelImage largest_component(const LabelImage& mask) {
  const ComponentImage components = connected_components(mask);
  const std::vector<std::size_t> n_voxels = sizes_of(components);
  LabelImage result(mask.grid);
  if (n_voxels.size() == 1)
    return result;
  const auto largest = std::max_element(n_voxels.begin() + 1, n_voxels.end()) - n_voxels.begin();
  std::transform(components.values.begin(), components.values.end(), result.values.begin(),
                 [&](std::uint32_t component) { return component == largest ? 1 : 0; });
  return result;
}

LabelImage without_small_parts(const LabelImage& mask, double volume) {
  const ComponentImage components = connected_components(mask);
  const std::vector<std::size_t> n_voxels = sizes_of(components);
  LabelImage result(mask.grid);
  const double least = volume / mask.grid.voxel_volume();
  std::transform(components.values.begin(), components.values.end(), result.values.begin(),
                 [&](std::uint32_t component) {
                   return component != 0 && double(n_voxels[component]) >= least ? 1 : 0;
                 });
  return result;
}

LabelImage inner_part(const LabelImage& mask, double distance) {
  const auto& size = mask.grid.size;
  const std::size_t strides[] = {1, size[0], size[0] * size[1]};
  std::array<std::size_t, 3> steps{};
  for (unsigned d = 0; d < 3; ++d)
    steps[d] = static_cast<std::size_t>(std::ceil(distance / mask.grid.spacing[d]));
  const auto is_inner = [&](std::size_t v) {
    for (unsigned d = 0; d < 3; ++d) {
      const std::size_t i = v / strides[d] % size[d];
      for (std::size_t n = 1; n <= steps[d]; ++n)
        if ((i >= n && mask.values[v - n * strides[d]] == 0) ||
            (i + n < size[d] && mask.values[v + n * strides[d]] == 0))
          return false;
    }
    return true;
  };
  LabelImage result(mask.grid);
  for (std::size_t v = 0; v < mask.values.size(); ++v)
    result.values[v] = mask.values[v] != 0 && is_inner(v) ? mask.values[v] : 0;
  return result;
}

LabelImage fill_holes(const LabelImage& mask) {
  const ComponentImage components = connected_components(select_labels(mask, {0}));
  const std::vector<bool> open = reaches_border(components);
  LabelImage result(mask.grid);
  std::transform(components.values.begin(), components.values.end(), result.values.begin(),
                 [&](std::uint32_t component) { return component == 0 || !open[component]; });
  return result;
}

} // namespace prosup::image
