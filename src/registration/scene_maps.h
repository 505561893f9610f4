#ifndef PROSUP_REGISTRATION_SCENE_MAPS_H
#define PROSUP_REGISTRATION_SCENE_MAPS_H

#include <array>
#include <vector>

#include "scene_breast.h"

namespace prosup::registration {

/// A breast as it is seen from the front: sums along lines of sight, on square pixels. The axes of
/// the picture are the patient's left and up, as far as these are at right angles to the front.
struct FrontView {
  std::array<int, 2> size{0, 0};
  std::vector<double> tissue; ///< thickness, mm
  std::vector<double> gland;  ///< thickness, mm
  std::vector<bool> chest;    ///< some chest lies in this line

  std::size_t n_pixels() const { return tissue.size(); }
};

/// The view along `front` with pixels of `edge`, mm.
FrontView front_view(const BreastMeasures& breast, const Labels& meaning,
                     const dealii::Tensor<1, 3>& front, double edge);

/// Share of the shadow of the tissue that has chest behind it; 0 if the front is not known.
double share_with_chest_behind(const BreastMeasures& breast, const Labels& meaning);

/// A measure of two breasts, and of the same ones if the second is turned over.
struct Turned {
  double as_is = 0., left_right = 0., head_foot = 0., half_turn = 0.;
};

/// Correlations of two views; shifts between them do not matter.
struct ViewFit {
  Turned tissue, gland;
};

ViewFit fit_of(const FrontView& a, const FrontView& b);

} // namespace prosup::registration

#endif
