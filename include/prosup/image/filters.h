#ifndef PROSUP_IMAGE_FILTERS_H
#define PROSUP_IMAGE_FILTERS_H

#include <optional>
#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::image {

// In masks, 0 means outside and any other value inside. Masks that are returned hold 0 and 1.
// Two voxels are neighbours if they share a face.

/// Convolves with a Gaussian of standard deviation `sigma_mm`. Outside the image, the
/// values of its border are used. If `sigma_mm` is 0, returns a copy.
/// @throws Error if sigma_mm is negative.
ScalarImage gaussian_smooth(const ScalarImage& image, double sigma_mm);

/// Resamples to voxels of `spacing_mm` in all directions. The field of view, measured to
/// the outer faces of the border voxels, is kept exactly: the spacing along each axis is the
/// extent divided by the nearest whole number of voxels. Along axes where the voxels become
/// larger the image is first smoothed, which avoids aliasing.
/// @throws Error if spacing_mm is not positive.
ScalarImage resample_isotropic(const ScalarImage& image, double spacing_mm);

/// The same for labels, by shape-based interpolation (Raya and Udupa, IEEE Trans. Med.
/// Imaging 9, 1990): each voxel gets the label with the smallest interpolated
/// signed_distance(). Thick slices leave no stair steps, and convex parts do not shrink as
/// they would with smoothing.
LabelImage resample_isotropic(const LabelImage& labels, double spacing_mm);

/// Two intensities, low < high.
struct IntensityRange {
  double low = 0.;
  double high = 1.;
};

/// Two percentiles (0 to 100) of the intensities inside the mask, interpolated between ranks.
/// @throws Error if the mask is empty or of another size, if the percentiles are not in
/// order, or if both are the same intensity.
IntensityRange robust_range(const ScalarImage& image, const LabelImage& mask, double low_percentile,
                            double high_percentile);

/// A value that fills the voxels beyond the field of view, as scanners and programs leave it in CT
/// (-2000, -3024): no intensity of what was imaged.
struct Padding {
  double value = 0.;
  double air = 0.;   ///< what replaced it: the median of the other voxels labelled air
  double share = 0.; ///< of the voxels labelled air
};

/// Replaces such a value, if there is one, where `labels` are 0. It is the smallest or largest of
/// those voxels, is further from all others than the air is from the body, and the others are
/// uniform and darker than the body.
std::optional<Padding> replace_padding(ScalarImage& image, const LabelImage& labels);

/// The range to which rescale() clamps.
inline constexpr IntensityRange rescaled_range{-0.5, 1.5};

/// Maps range.low to 0 and range.high to 1 linearly, and clamps to `rescaled_range`. The range
/// should come from the tissue. Clamping limits the weight of voxels that are much brighter or
/// darker (clips, air in CT, flow artefacts), which squared differences would otherwise
/// exaggerate. The margin of 0.5 on both sides keeps the contrast in the tails of the tissue
/// and leaves edges to such voxels visible.
/// @throws Error if range.low >= range.high.
ScalarImage rescale(const ScalarImage& image, IntensityRange range);

/// Mask of the voxels whose value is one of `labels`.
LabelImage select_labels(const LabelImage& image, const std::vector<unsigned>& labels);

/// The largest connected part of a mask; an empty mask stays empty.
LabelImage largest_component(const LabelImage& mask);

/// A mask without its connected parts that are smaller than `volume`, mm^3.
LabelImage without_small_parts(const LabelImage& mask, double volume);

/// The part of a mask that has nothing but mask around it along the axes: up to the voxel that is
/// `distance` (mm) or more away in each of the six directions. What lies beyond the image is not
/// outside.
LabelImage inner_part(const LabelImage& mask, double distance);

/// Fills the cavities of a mask: outside voxels that are not connected to the border of the
/// image.
LabelImage fill_holes(const LabelImage& mask);

/// Distance from voxel centres to the boundary of a mask, mm, negative inside. It is zero on
/// the faces between inside and outside voxels. The border of the image is no boundary. Far
/// from a curved or oblique boundary the distance is up to half a voxel too small, since
/// corners of voxels stick out.
/// @throws Error if the mask has no inside or no outside.
ScalarImage signed_distance(const LabelImage& mask);

/// Adds `n_layers` voxels on all sides. Values are continued as an odd function about each
/// border voxel, which continues linear functions linearly. Along an axis of one voxel the
/// value stays constant.
ScalarImage extended(const ScalarImage& image, unsigned n_layers);

/// Replaces the value of each voxel where `known` is 0 by that of the nearest voxel, in mm,
/// where it is not.
/// @throws Error if `known` is 0 everywhere or the sizes differ.
void extend_from_nearest(VectorImage& field, const LabelImage& known);

/// Distance of each voxel, mm, from the nearest one where `known` is not 0.
/// @throws Error if `known` is 0 everywhere.
ScalarImage distance_from(const LabelImage& known);

/// Resamples `loaded` on the grid of the displacement u: the result at X is loaded(X + u(X)),
/// or `outside` if X + u(X) lies outside the field of view of `loaded`.
ScalarImage warp(const ScalarImage& loaded, const VectorImage& displacement, float outside = 0.f);

} // namespace prosup::image

#endif
