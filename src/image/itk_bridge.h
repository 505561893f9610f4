#ifndef PROSUP_SRC_IMAGE_ITK_BRIDGE_H
#define PROSUP_SRC_IMAGE_ITK_BRIDGE_H

#include <itkImage.h>
#include <itkVector.h>

#include <cstring>

#include "prosup/image/voxel_image.h"

namespace prosup::image {

template <typename T>
struct ItkPixel {
  using Type = T;
};
template <>
struct ItkPixel<std::array<float, 3>> {
  using Type = itk::Vector<float, 3>;
  static_assert(sizeof(Type) == sizeof(std::array<float, 3>), "memory is shared between the two");
};

template <typename T>
using ItkImage = itk::Image<typename ItkPixel<T>::Type, 3>;

void set_geometry(itk::ImageBase<3>& image, const VoxelGrid& grid);

/// An ITK image that shares the values of `image`, for reading: `image` must
/// outlive it, and no filter may run in place on it.
template <typename T>
typename ItkImage<T>::Pointer as_itk(const VoxelImage<T>& image) {
  auto view = ItkImage<T>::New();
  typename ItkImage<T>::SizeType size;
  for (unsigned d = 0; d < 3; ++d)
    size[d] = image.grid.size[d];
  view->SetRegions(size);
  set_geometry(*view, image.grid);
  using Pixel = typename ItkPixel<T>::Type;
  auto* values = reinterpret_cast<Pixel*>(const_cast<T*>(image.values.data()));
  view->GetPixelContainer()->SetImportPointer(values, image.values.size(), false);
  return view;
}

/// Copies the values of an ITK image that lies on `grid`.
template <typename T>
VoxelImage<T> from_itk(const ItkImage<T>& image, const VoxelGrid& grid) {
  VoxelImage<T> result(grid);
  std::memcpy(static_cast<void*>(result.values.data()), image.GetBufferPointer(),
              result.values.size() * sizeof(T));
  return result;
}

} // namespace prosup::image

#endif
