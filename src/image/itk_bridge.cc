#include "itk_bridge.h"

namespace prosup::image {

void set_geometry(itk::ImageBase<3>& image, const VoxelGrid& grid) {
  itk::ImageBase<3>::PointType origin;
  itk::ImageBase<3>::SpacingType spacing;
  itk::ImageBase<3>::DirectionType direction;
  for (unsigned d = 0; d < 3; ++d) {
    origin[d] = grid.origin[d];
    spacing[d] = grid.spacing[d];
    for (unsigned e = 0; e < 3; ++e)
      direction(d, e) = grid.direction[d][e];
  }
  image.SetOrigin(origin);
  image.SetSpacing(spacing);
  image.SetDirection(direction);
}

} // namespace prosup::image
