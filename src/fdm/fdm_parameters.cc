#include "prosup/fdm/fdm_parameters.h"

#include "prosup/core/parameters.h"

namespace prosup::fdm {

using namespace dealii;

const std::vector<std::string>& border_names() {
  static const std::vector<std::string> names{"automatic", "padded", "fixed"};
  return names;
}

const std::vector<std::string>& correction_names() {
  static const std::vector<std::string> names{"relaxed", "full"};
  return names;
}

const std::vector<std::string>& slave_motion_names() {
  static const std::vector<std::string> names{"projection", "gradual"};
  return names;
}

FdmParameters::FdmParameters()
    : ParameterAcceptor("FDM"), border(border_names().front()),
      correction(correction_names().front()), slave_motion(slave_motion_names().front()) {}

Border FdmParameters::border_scheme() const {
  return enumerator<Border>(border, border_names());
}

Correction FdmParameters::correction_scheme() const {
  return enumerator<Correction>(correction, correction_names());
}

SlaveMotion FdmParameters::slave_motion_scheme() const {
  return enumerator<SlaveMotion>(slave_motion, slave_motion_names());
}

void FdmParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Spacing", spacing, "h, spacing of the simulation grid. Units: mm.",
                    Patterns::Double(0.1, 100.));
  prm.add_parameter("Padding", padding,
                    "How far the simulation grid reaches beyond the image on all sides; there "
                    "u = 0. Units: mm.",
                    Patterns::Double(0., 1000.));
  prm.add_parameter(
      "Border", border,
      "What surrounds the image; there everything goes on as at its border. padded: it moves "
      "as far as the grid reaches, as in the paper. fixed: u = 0 on and beyond the "
      "faces of the image that tissue touches. automatic: padded where tissue is fixed to a "
      "chest, and fixed where it slides or there is none. Units: none.",
      one_of(border_names()));
  prm.add_parameter(
      "Background stiffness", background_stiffness,
      "Stiffness of air over that of the softest tissue; rises to 0.1 in a simulation "
      "that diverges. Units: none.",
      Patterns::Double(1e-4, 1.));
  prm.add_parameter("Map spacing", map_spacing,
                    "Spacing of the grid on which the material of the loaded image is kept, over "
                    "that of the simulation grid. Units: none.",
                    Patterns::Double(0.05, 4.));
  prm.add_parameter("Correction", correction,
                    "How the map w, by which the material is pulled back every n steps of length "
                    "h_t, follows the displacement u. relaxed: w <- w + min(1, n h_t/tau) (u - w). "
                    "full: w <- u, as in the paper (its eq. 9). Units: none.",
                    one_of(correction_names()));
  prm.add_parameter("Lag factor", lag_factor,
                    "tau r/rho of the relaxed correction: the time tau in which w follows u, times "
                    "the damping rate. Units: none.",
                    Patterns::Double(1e-3, 1e6));
  prm.add_parameter("Resampling interval", resampling_interval,
                    "n, steps between two resamplings of the material (n_invert of the paper's "
                    "Fig. 3). Units: none.",
                    Patterns::Integer(1, 100000));
  prm.add_parameter("Damping", damping,
                    "r/rho of the paper's eq. 1, a multiple of the density; 0: twice the lowest "
                    "frequency, estimated from the motion. Units: 1/s.",
                    Patterns::Double(0., 1e6));
  prm.add_parameter("Gravity ramp", gravity_ramp,
                    "Time in which gravity rises linearly to its full value, times the damping "
                    "rate. Units: none.",
                    Patterns::Double(0., 1e6));
  prm.add_parameter("Step safety", step_safety,
                    "h_t over the estimate of the critical time step. Units: none.",
                    Patterns::Double(1e-3, 2.));
  prm.add_parameter("Slave motion", slave_motion,
                    "How nodes on a chest wall that tissue slides on get back to it. projection: "
                    "they are on it after each step. gradual: by s(v_s) of the paper's eq. 11. "
                    "Units: none.",
                    one_of(slave_motion_names()));
  prm.add_parameter("Slave correction", slave_correction,
                    "p of the paper's eq. 11, of the gradual slave motion. Units: none.",
                    Patterns::Double(1e-9, 1.));
  prm.add_parameter("Slave speed", slave_speed,
                    "v_max of the paper's eq. 11, of the gradual slave motion. Units: mm/s.",
                    Patterns::Double(1e-6, 1e9));
  prm.add_parameter("Residual tolerance", residual_tolerance,
                    "Stop when the norm of the out-of-balance forces in the tissue is below this "
                    "part of the norm of the weight. Units: none.",
                    Patterns::Double(1e-12, 1.));
  prm.add_parameter("Position tolerance", position_tolerance,
                    "Stop when also max |w - u| in the tissue is below this. Units: mm.",
                    Patterns::Double(1e-9, 10.));
  prm.add_parameter("Maximum steps", max_steps, "Give up after this many time steps. Units: none.",
                    Patterns::Integer(1, 100000000));
  prm.add_parameter("Maximum retries", max_retries,
                    "How often a simulation that diverges goes back to a good state and continues "
                    "with stiffer air or a longer lag, a smaller step and a slower ramp. Units: "
                    "none.",
                    Patterns::Integer(0, 100));
}

} // namespace prosup::fdm
