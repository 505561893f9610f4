#ifndef PROSUP_PREPARE_TISSUES_H
#define PROSUP_PREPARE_TISSUES_H

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

/// Fat and gland of a breast.
struct Tissues {
  image::LabelImage gland;     ///< 1 where there is more gland than fat
  image::ScalarImage fraction; ///< of gland in each voxel, 0 to 1
  double fat = 0., gland_intensity = 0., deviation = 0.;
  double separation() const; ///< of fat and gland, in standard deviations
};

/// How the tissues differ in the image.
struct TissueImage {
  const image::ScalarImage& image; ///< without bias
  const image::LabelImage& inner;  ///< 1 in the breast without its skin
  bool is_ct = false;
  bool fat_is_bright = true;
};

/// Expectation maximisation of a mixture of two Gaussians with one deviation, fat (mu_0) and gland
/// (mu_1), with a Markov random field as prior (Zhang et al., IEEE Trans. Med. Imaging 20, 2001) in
/// the mean-field approximation:
///   ln q_1(x) / q_0(x) = c^2 (f(x) - 1/2) + ln pi_1 / pi_0 + beta sum_y w(x, y) (q_1(y) - q_0(y)),
///   f = min( (I / g - mu_0) / (mu_1 - mu_0), 1 ),  c = |mu_1 - mu_0| / sigma,
/// where y are the six neighbours of x, weighted by 1 / distance with sum 1, and g is what is left
/// of the bias field: the mean of I / mu_0 with the weights q_0, over 10 mm (as Wells et al., IEEE
/// Trans. Med. Imaging 15, 1996); g = 1 in CT. beta is 1.5 while the tissues are found. Then, with
/// pi_1 = pi_0 and beta = 0.5, the labels follow the middle between the tissues, and thin strands
/// of gland stay. Connected parts of gland of less than 0.2 ml, which are vessels and noise, become
/// fat.
///
/// The fraction of gland is f, not below 0, in voxels that touch gland, and 0 elsewhere.
/// @throws Error if `inner` is empty.
Tissues find_tissues(const TissueImage& image);

} // namespace prosup::prepare

#endif
