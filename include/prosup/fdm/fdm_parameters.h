#ifndef PROSUP_FDM_FDM_PARAMETERS_H
#define PROSUP_FDM_FDM_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace prosup::fdm {

/// What surrounds the image.
enum class Border {
  automatic, ///< padded where tissue is fixed to a chest, else fixed
  padded,    ///< what is at its border goes on and moves, up to that of the grid
  fixed      ///< u = 0 on and beyond the faces of the image box that tissue touches
};
const std::vector<std::string>& border_names();

/// How the pull-back map w follows the displacement u.
enum class Correction {
  relaxed, ///< w <- w + min(1, n h_t/tau) (u - w)
  full     ///< w <- u, the paper's (its eq. 9)
};
const std::vector<std::string>& correction_names();

/// How slave nodes get back to their surface.
enum class SlaveMotion {
  projection, ///< s = 1: they are on it after each step
  gradual     ///< s(v_s) of the paper's eq. 11
};
const std::vector<std::string>& slave_motion_names();

/// Parameters of the finite-difference method, section "FDM"; the same for
/// prone and supine.
class FdmParameters : public dealii::ParameterAcceptor {
public:
  FdmParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  Border border_scheme() const;
  Correction correction_scheme() const;
  SlaveMotion slave_motion_scheme() const;

  double spacing = 8.;                 ///< h, mm
  double padding = 40.;                ///< mm
  std::string border;                  ///< of border_names()
  double background_stiffness = 0.025; ///< mu over that of the softest tissue
  double map_spacing = 1.25;           ///< of the maps, over h
  std::string correction;              ///< of correction_names()
  double lag_factor = 2.5;             ///< tau r/rho, of the relaxed correction
  unsigned resampling_interval = 10;   ///< n_invert, steps
  double damping = 0.;                 ///< r/rho, 1/s; 0: automatic
  double gravity_ramp = 1.;            ///< times the damping time
  double step_safety = 0.8;            ///< of the critical time step
  std::string slave_motion;            ///< of slave_motion_names()
  double slave_correction = 0.005;     ///< p
  double slave_speed = 50.;            ///< v_max, mm/s
  double residual_tolerance = 2e-3;    ///< relative
  double position_tolerance = 0.02;    ///< mm
  unsigned max_steps = 20000;
  unsigned max_retries = 6;
};

} // namespace prosup::fdm

#endif
