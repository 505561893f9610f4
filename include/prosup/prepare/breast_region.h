#ifndef PROSUP_PREPARE_BREAST_REGION_H
#define PROSUP_PREPARE_BREAST_REGION_H

#include <string>
#include <vector>

#include "prosup/image/voxel_box.h"
#include "prosup/prepare/trunk.h"

namespace prosup::prepare {

/// Which breasts are wanted.
enum class Side { both, left, right };

/// "both", "left", "right", in the order of the enumerators.
const std::vector<std::string>& side_names();

/// A breast is what stands out in front of the chest: columns of the trunk in which tissue is
/// thicker than this, mm.
inline constexpr double least_breast_thickness = 30.;

/// The box of one breast with `margin` mm around it, or the whole grid for both. `front` is not 0
/// in the tissue in front of the chest. The patient's left and right meet at the axis of the trunk.
/// @throws Error if there is no breast on that side.
image::VoxelBox breast_box(const image::LabelImage& front, const TrunkSurface& chest, Side side,
                           double margin);

/// @throws Error if the breast is cut off by the front border of the image, which shows more than
/// 4 cm^2 of tissue.
void require_whole_front(const image::LabelImage& front);

/// How much of a breast the image may cut off: the border of the image at a side, above or below
/// shows a section of it; this is the largest, over the largest of all sections parallel to it.
struct CutSection {
  double share = 0.;
  double area = 0.; ///< cm^2
  const char* side = "";
  const char* where = "";
};

/// Of the breasts that are wanted, within `widest_breast` of the front. `front` and `chest` as in
/// breast_box().
CutSection largest_cut(const image::LabelImage& front, const TrunkSurface& chest, Side side);

/// @throws Error if the section is larger than 0.7 of the largest and 10 cm^2: then a sizeable part
/// of the breast and its skin lies beyond.
void require_whole_breast(const CutSection& cut);

/// The section of a breast with the plane between the patient's left and right, over the largest
/// section parallel to it on the side that is wanted. 0 for both sides.
double section_in_the_middle(const image::LabelImage& front, const TrunkSurface& chest, Side side);

/// @throws Error if that section is larger than 0.5: then the scan shows one breast, whose middle
/// was taken for that of the trunk.
void require_two_sides(double middle_share, Side side);

} // namespace prosup::prepare

#endif
