#ifndef PROSUP_PREPARE_PREPARATION_H
#define PROSUP_PREPARE_PREPARATION_H

#include <deal.II/base/parameter_acceptor.h>

#include <optional>
#include <string>
#include <vector>

#include "prosup/core/labels.h"
#include "prosup/core/log.h"
#include "prosup/image/voxel_image.h"
#include "prosup/prepare/breast_region.h"
#include "prosup/prepare/chest_wall.h"
#include "prosup/prepare/contrast.h"
#include "prosup/prepare/implant.h"
#include "prosup/prepare/unknown_region.h"

namespace prosup::prepare {

/// How sure the segmentation of one scan is.
struct Confidence {
  double weak_edge = 0.; ///< share of the chest wall under the breasts with little contrast
  /// Of the chest wall, cm^2: where it was continued behind tissue that looks like muscle, and
  /// where it is far from a smooth chest.
  double bridged_area = 0., odd_area = 0.;
  double separation = 0.; ///< of fat and gland, in standard deviations
  double cut_share = 0.;  ///< of the section of a breast, at the border of the image
  SolidPart solid;
  std::vector<std::string> doubts; ///< one sentence each
};

/// What a registration needs of one scan.
struct PreparedScan {
  image::ScalarImage image; ///< without bias
  image::LabelImage labels; ///< air, chest, fat and gland, with the numbers of Labels
  image::ScalarImage gland; ///< fraction of gland, 0 to 1
  Contrast contrast = Contrast::t1;
  double fat_volume = 0., gland_volume = 0.; ///< ml
  double unknown_contact = 0.; ///< cm^2 on which tissue ends because the scan shows no more
  Confidence confidence;
};

/// Masks of the user, not 0 where they apply, on any grid: resampled by the nearest voxel. Each
/// replaces what would be found.
struct UserMasks {
  /// All of the chest, or its muscle: its front is the chest wall, and the body behind it is chest.
  /// Where no ray from the axis of the trunk meets the mask, its surroundings are continued.
  std::optional<image::LabelImage> chest;
  /// Of a breast or both, with or without skin: other tissue is chest, but for skin on the breast.
  std::optional<image::LabelImage> breast;
  std::optional<image::LabelImage> gland;
};

/// The stage from a scan to an image and labels that a registration can start from; section
/// "Preparation". Knows no mechanics.
class Preparation : public dealii::ParameterAcceptor {
public:
  /// Keeps a reference to `labels`.
  explicit Preparation(const Labels& labels);
  explicit Preparation(Labels&&) = delete;
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// Finds body, chest wall, fat and gland, as far as `masks` do not give them. For one rank.
  /// @throws Error if there is no body, no chest or no breast, if a breast is cut off, if a side is
  /// wanted of a scan of one breast, if a CT is said to be MR or the reverse, or if a mask marks
  /// nothing of the scan.
  PreparedScan run(image::ScalarImage scan, const Log& log, const UserMasks& masks = {}) const;

private:
  Contrast contrast_of(const image::ScalarImage& scan) const;
  ChestWall wall_of(const ChestImage& image, const TrunkAxis& axis, const UserMasks& masks,
                    PreparedScan& result) const;
  /// Labels of a body that is split at the chest wall.
  image::LabelImage labels_of(const image::LabelImage& parts, const image::LabelImage& gland) const;
  /// Marks what the scan does not show in its parts, and gives it the intensity of air.
  void mark_unknown(const UnknownRegion& region, double air, image::ScalarImage& scan,
                    image::LabelImage& parts, const Log& log) const;

  std::string contrast_ = "automatic", bias_correction_ = "n4", side_ = "both";
  double skin_ = 2.5;   ///< mm
  double margin_ = 25.; ///< mm
  const Labels& labels_;
};

} // namespace prosup::prepare

#endif
