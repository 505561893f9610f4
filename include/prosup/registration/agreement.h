#ifndef PROSUP_REGISTRATION_AGREEMENT_H
#define PROSUP_REGISTRATION_AGREEMENT_H

#include <optional>

#include "prosup/registration/breast_pair.h"
#include "prosup/registration/comparison.h"

namespace prosup::registration {

/// How far the two unloaded breasts agree, whatever they are compared by: both are the same body,
/// so that outlines, gland and intensities have to fall on each other. Voxels of the chest, and
/// those that one image does not show, do not count. No landmarks are used.
struct Agreement {
  double compared_share = 0.; ///< of the smaller breast that both images show
  double volume_ratio = 1.;   ///< of the larger breast to the smaller one, where compared
  double breast_dice = 0.;    ///< 2 |P and S|/(|P| + |S|)
  double gland_dice = 1.;     ///< the same of the gland; 1 if neither has any
  double skin_distance = 0.;  ///< mean distance of the outlines, mm
  double skin_p95 = 0.;       ///< its 95th percentile, mm
  double outside_share = 0.;  ///< of a breast, more than `far_outside` out of the other
  /// Of the intensities where both breasts are: Pearson's correlation, the mean squared
  /// correlation in small windows, and normalised mutual information minus 1.
  struct Intensities {
    double correlation = 0., local_correlation = 0., mutual_information = 0.;
  };
  std::optional<Intensities> intensities;
};

inline constexpr double far_outside = 5.; ///< mm

/// The agreement of the pair's present state; the intensities, which take most of the time, only if
/// asked for. Collective on the ranks of both breasts; the same on all of them.
Agreement measure_agreement(const BreastPair& pair, const ComparedImages& compared,
                            bool with_intensities);

/// How far the surfaces of the two chest labels, where tissue lies on them, are apart.
struct ChestMisfit {
  double shared = 0.; ///< part of the surfaces that lies in the field of view of both images
  double median = 0.; ///< of the distances, mm
  double p95 = 0.;    ///< mm
};

/// Zero if an image has no such surface. For one rank.
ChestMisfit measure_chest_misfit(const similarity::Scene& scene);

} // namespace prosup::registration

#endif
