#ifndef PROSUP_FDM_FDM_PARAMETERS_H
#define PROSUP_FDM_FDM_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

#include "prosup/settling/settling_parameters.h"

namespace prosup::fdm {

/// What surrounds the image.
enum class Border {
  automatic, ///< padded where tissue is fixed to a chest, otherwise fixed
  padded,    ///< the border voxels continue to the border of the grid, and may move
  fixed      ///< u = 0 on and beyond the faces of the image box that tissue touches
};
const std::vector<std::string>& border_names();

/// How nodes that slide on the chest are kept on its surface.
enum class ContactMethod {
  projection, ///< s = 1: they are on it after each step
  gradual     ///< s(v_s) of the paper's eq. 11
};
const std::vector<std::string>& contact_method_names();

/// Parameters of the finite-difference method, section "FDM"; the same for
/// prone and supine.
class FdmParameters : public dealii::ParameterAcceptor, public settling::SettlingParameters {
public:
  FdmParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  Border border_scheme() const;
  ContactMethod contact_method() const;

  double spacing = 8.;                 ///< h, mm
  double padding = 40.;                ///< mm
  std::string border;                  ///< of border_names()
  double background_stiffness = 0.025; ///< mu over that of the softest tissue
  double map_spacing = 1.25;           ///< of the maps, over h
  double damping_rate = 0.;            ///< r/rho, 1/s; 0: automatic
  std::string contact;                 ///< of contact_method_names()
  double correction_part = 0.005;      ///< p of eq. 11
  double speed_limit = 50.;            ///< v_max of eq. 11, mm/s
};

} // namespace prosup::fdm

#endif
