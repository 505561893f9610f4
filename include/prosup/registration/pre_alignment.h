#ifndef PROSUP_REGISTRATION_PRE_ALIGNMENT_H
#define PROSUP_REGISTRATION_PRE_ALIGNMENT_H

#include <deal.II/base/parameter_acceptor.h>

#include <optional>
#include <string>

#include "prosup/image/rigid_alignment.h"
#include "prosup/similarity/domain.h"

namespace prosup::registration {

/// How the supine chest comes to lie on the prone one.
struct Alignment {
  image::RigidTransform transform; ///< from supine to prone positions
  std::string method;
  image::SurfaceAlignment surface;
  std::optional<image::IntensityAlignment> intensities;
};

/// Rigid alignment of the chest walls before anything else, section
/// "Pre-alignment". The paper takes it as done by hand, on chest wall and sternum.
///
/// The surfaces of the chest labels come first: it is on them that the model holds
/// the tissue. They leave open what slides along them (along and about the axis of a
/// chest that is a cylinder); the intensities of the chest wall, with its ribs,
/// decide that. Rotations come from the surfaces only: about the axis of a cylinder
/// with oblique ribs, a rotation and a translation look the same.
class PreAlignment : public dealii::ParameterAcceptor {
public:
  PreAlignment();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  bool wanted() const { return method_ != "none"; }

  /// For one rank. The images are as they were read; they need not lie on the
  /// voxels of the scene's labels.
  /// @throws Error if the chest walls have nothing in common.
  Alignment run(const image::ScalarImage& prone, const image::ScalarImage& supine,
                const similarity::Scene& scene) const;

private:
  std::string method_ = "none";
  std::string freedom_ = "rigid";
  double depth_ = 30.; ///< mm
  double reach_ = 12.; ///< mm
};

/// One line on what was found.
std::string describe(const Alignment& alignment);

} // namespace prosup::registration

#endif
