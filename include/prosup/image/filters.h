#ifndef PROSUP_IMAGE_FILTERS_H
#define PROSUP_IMAGE_FILTERS_H

#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::image {

// In masks, zero is outside and any other value inside; the masks returned
// hold 0 and 1. Voxels are neighbours when they share a face.

/// Convolves with a Gaussian of standard deviation `sigma_mm`; beyond the
/// border the image goes on with its border values. Zero gives a copy.
/// @throws Error if sigma_mm is negative.
ScalarImage gaussian_smooth(const ScalarImage& image, double sigma_mm);

/// Resamples to voxels of `spacing_mm` in all directions. The field of view,
/// measured to the outer faces of the border voxels, is kept exactly; for that
/// the spacing along each axis becomes the extent divided by the nearest whole
/// number of voxels. Where voxels grow, the image is smoothed before, so that
/// the point-spread function of a voxel grows alike.
/// @throws Error if spacing_mm is not positive.
ScalarImage resample_isotropic(const ScalarImage& image, double spacing_mm);

/// As above for labels, by shape: each voxel takes the label whose
/// signed_distance(), interpolated there, is smallest (Raya and Udupa, IEEE
/// Trans. Med. Imaging 9, 1990). Thick slices leave no stairs, and convex parts
/// do not shrink as they would by smoothing.
LabelImage resample_isotropic(const LabelImage& labels, double spacing_mm);

/// Two intensities, low < high.
struct IntensityRange {
  double low = 0.;
  double high = 1.;
};

/// Percentiles (0 to 100) of the intensities inside the mask, interpolated
/// between ranks.
/// @throws Error if the mask is empty or of another size, if the percentiles
/// are not ordered, or if both have the same intensity.
IntensityRange robust_range(const ScalarImage& image, const LabelImage& mask, double low_percentile,
                            double high_percentile);

/// What rescale() clamps to.
inline constexpr IntensityRange rescaled_range{-0.5, 1.5};

/// Maps range.low to 0 and range.high to 1, and clamps to [-0.5, 1.5]. A squared
/// difference weighs outliers by their square: what is far brighter or darker
/// than the tissue the range was taken from (clips, air in CT, flow artefacts)
/// may count as a contrast of half the range, so that edges towards it still
/// pull, but no more. The mapping is linear a good way beyond both ends, so that
/// contrast in the tails of the tissue is kept.
/// @throws Error if range.low >= range.high.
ScalarImage rescale(const ScalarImage& image, IntensityRange range);

/// Mask of the voxels that have one of `labels`.
LabelImage select_labels(const LabelImage& image, const std::vector<unsigned>& labels);

/// The largest connected part of a mask; an empty mask stays empty.
LabelImage largest_component(const LabelImage& mask);

/// Fills the cavities of a mask: outside voxels from which no path leads to
/// the border of the image.
LabelImage fill_holes(const LabelImage& mask);

/// Distance from voxel centres to the boundary of a mask, mm, negative inside.
/// It is zero on the faces between inside and outside voxels, not at centres;
/// the border of the image is no boundary. Far from a curved or oblique boundary
/// it falls short by up to half a voxel, since its stairs stick out.
/// @throws Error if the mask has no inside or no outside.
ScalarImage signed_distance(const LabelImage& mask);

/// Adds `n_layers` voxels all round, continuing the values as an odd function
/// about each border voxel, so that what is linear goes on linearly; the value
/// goes on unchanged along an axis of one voxel.
ScalarImage extended(const ScalarImage& image, unsigned n_layers);

/// Gives each voxel where `known` is zero the value of the nearest voxel (in
/// mm, between centres) where it is not.
/// @throws Error if nothing is known or the sizes differ.
void extend_from_nearest(VectorImage& field, const LabelImage& known);

/// Pulls `loaded` to the grid of `displacement`: at each of its points X the
/// result is loaded(X + u(X)), and `outside` where X + u lies outside the field
/// of view of `loaded`.
ScalarImage warp(const ScalarImage& loaded, const VectorImage& displacement, float outside = 0.f);

} // namespace prosup::image

#endif
