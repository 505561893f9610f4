#ifndef PROSUP_UNLOADING_SUPPORT_PARAMETERS_H
#define PROSUP_UNLOADING_SUPPORT_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include <memory>
#include <string>
#include <vector>

#include "prosup/image/voxel_image.h"
#include "prosup/mechanics/body/supports.h"

namespace prosup::unloading {

/// How tissue may move on the chest wall.
enum class ChestCondition {
  fixed,    ///< not at all
  sliding,  ///< along it
  one_sided ///< along it and away from it
};

/// Names of the conditions, in the order of the enumerators.
const std::vector<std::string>& chest_condition_names();

/// Faces of the base of a sliding breast, of all ranks.
struct BaseFaces {
  unsigned n_all = 0;
  unsigned n_held = 0; ///< because the chest has no clear normal there
};

/// What holds a breast at the chest wall and at the border of the image, section
/// "Supports"; the same for prone and supine.
class SupportParameters : public dealii::ParameterAcceptor {
public:
  SupportParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// The supports of a body that was meshed from `labels`. `other` are the labels in the
  /// other position, empty if they are not known. Collective on the communicator of the
  /// body. `faces` is left as it is if the tissue does not slide.
  /// @throws Error if tissue is to slide and there is no chest.
  std::unique_ptr<mechanics::Supports> make(ChestCondition chest, const mechanics::Body& body,
                                            const image::LabelImage& labels,
                                            const image::LabelImage& other, unsigned chest_label,
                                            BaseFaces* faces = nullptr) const;

  /// Whether make() needs `labels`.
  bool need_labels(ChestCondition chest) const {
    return chest != ChestCondition::fixed || cut_planes_ == "sliding";
  }

  /// Stiffness of the springs on the chest wall, Pa/mm; 0 if tissue is fixed to it.
  double chest_stiffness(ChestCondition chest) const {
    return chest == ChestCondition::fixed ? 0. : chest_stiffness_;
  }

  /// How many times as stiff they are where the chest faces sideways.
  double lateral_chest_ratio() const { return lateral_chest_ratio_; }

  /// Stiffness of the springs on cut planes, Pa/mm; 0 if there are none.
  double cut_plane_stiffness() const {
    return cut_planes_ == "yielding" || cut_planes_ == "sliding" || cut_planes_ == "elastic"
               ? cut_plane_stiffness_
               : 0.;
  }

  /// Whether make() needs `other`.
  bool need_other_labels() const { return cut_planes_ == "common" || cut_planes_ == "yielding"; }

  double contact_stiffness = 5e4; ///< of Newton's penalty, Pa/mm

private:
  void add_chest(ChestCondition chest, const image::LabelImage& labels, unsigned chest_label,
                 mechanics::Supports& supports, BaseFaces* faces) const;
  void add_cut_planes(const image::VoxelGrid& grid, const image::LabelImage& other,
                      mechanics::Supports& supports) const;

  double chest_stiffness_ = 8.;
  double lateral_chest_ratio_ = 1.;
  double chest_smoothing_ = 1.5;
  std::string contact_method_ = "projection";
  mechanics::GradualCorrection gradual_;
  std::string cut_planes_ = "yielding";
  double cut_plane_stiffness_ = 40.;
};

} // namespace prosup::unloading

#endif
