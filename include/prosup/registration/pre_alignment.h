#ifndef PROSUP_REGISTRATION_PRE_ALIGNMENT_H
#define PROSUP_REGISTRATION_PRE_ALIGNMENT_H

#include <deal.II/base/parameter_acceptor.h>

#include <optional>
#include <string>

#include "prosup/image/rigid_alignment.h"
#include "prosup/similarity/domain.h"

namespace prosup::registration {

/// The rigid motion that takes the supine chest to the prone one, and how well it fits.
struct Alignment {
  image::RigidTransform transform; ///< from supine to prone positions
  std::string method;
  image::SurfaceAlignment surface;
  std::optional<image::IntensityAlignment> intensities;
};

/// Rigid alignment of the chest walls, before anything else; section "Pre-alignment". In the
/// paper this was done by hand, on chest wall and sternum.
///
/// First the surfaces of the chest labels are aligned, since the model holds the tissue on
/// them. They do not determine motions that slide them along each other, such as along and
/// about the axis of a cylindrical chest. Translations of this kind are found from the
/// intensities of the chest wall with its ribs. Rotations are found from the surfaces alone:
/// about the axis of a cylinder with oblique ribs, a rotation looks like a translation.
class PreAlignment : public dealii::ParameterAcceptor {
public:
  PreAlignment();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  bool wanted() const { return method_ != "none"; }

  /// For one rank. The images are as they were read; their voxels may differ from those of
  /// the labels of the scene. Nothing if the method is automatic, and the chests are near enough or
  /// cannot be laid on each other by a small motion.
  /// @throws Error if the chest walls do not overlap, unless the method is automatic.
  std::optional<Alignment> run(const image::ScalarImage& prone, const image::ScalarImage& supine,
                               const similarity::Scene& scene) const;

private:
  Alignment aligned(const image::ScalarImage& prone, const image::ScalarImage& supine,
                    const similarity::Scene& scene) const;

  std::string method_ = "automatic";
  std::string freedom_ = "rigid";
  double layer_depth_ = 30.;     ///< mm
  double search_distance_ = 12.; ///< mm
};

/// A few lines for the log.
std::string describe(const Alignment& alignment);

} // namespace prosup::registration

#endif
