#ifndef PROSUP_PREPARE_PREPARATION_H
#define PROSUP_PREPARE_PREPARATION_H

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

#include "prosup/core/labels.h"
#include "prosup/core/log.h"
#include "prosup/image/voxel_image.h"
#include "prosup/prepare/breast_region.h"
#include "prosup/prepare/contrast.h"

namespace prosup::prepare {

/// How sure the segmentation of one scan is.
struct Confidence {
  double weak_edge = 0.;  ///< share of the chest wall under the breasts with little contrast
  double separation = 0.; ///< of fat and gland, in standard deviations
  std::vector<std::string> doubts; ///< one sentence each
};

/// What a registration needs of one scan.
struct PreparedScan {
  image::ScalarImage image; ///< without bias
  image::LabelImage labels; ///< air, chest, fat and gland, with the numbers of Labels
  image::ScalarImage gland; ///< fraction of gland, 0 to 1
  Contrast contrast = Contrast::t1;
  double fat_volume = 0., gland_volume = 0.; ///< ml
  Confidence confidence;
};

/// The stage from a scan to an image and labels that a registration can start from; section
/// "Preparation". Knows no mechanics.
class Preparation : public dealii::ParameterAcceptor {
public:
  /// Keeps a reference to `labels`.
  explicit Preparation(const Labels& labels);
  explicit Preparation(Labels&&) = delete;
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// Finds body, chest wall, fat and gland. For one rank.
  /// @throws Error if there is no body, no chest or no breast, or if a breast is cut off.
  PreparedScan run(image::ScalarImage scan, const Log& log) const;

private:
  Contrast contrast_of(const image::ScalarImage& scan) const;
  /// Labels of a body that is split at the chest wall.
  image::LabelImage labels_of(const image::LabelImage& parts, const image::LabelImage& gland) const;

  std::string contrast_ = "automatic", bias_correction_ = "n4", side_ = "both";
  double skin_ = 2.5;   ///< mm
  double margin_ = 25.; ///< mm
  const Labels& labels_;
};

} // namespace prosup::prepare

#endif
