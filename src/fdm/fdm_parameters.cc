#include "prosup/fdm/fdm_parameters.h"

#include "prosup/core/parameters.h"

namespace prosup::fdm {

using namespace dealii;

const std::vector<std::string>& border_names() {
  static const std::vector<std::string> names{"automatic", "padded", "fixed"};
  return names;
}

const std::vector<std::string>& contact_method_names() {
  static const std::vector<std::string> names{"projection", "gradual"};
  return names;
}

FdmParameters::FdmParameters()
    : ParameterAcceptor("FDM"), SettlingParameters(0.8), border(border_names().front()),
      contact(contact_method_names().front()) {}

Border FdmParameters::border_scheme() const {
  return enumerator<Border>(border, border_names());
}

ContactMethod FdmParameters::contact_method() const {
  return enumerator<ContactMethod>(contact, contact_method_names());
}

void FdmParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Spacing", spacing, "h, spacing of the simulation grid. Units: mm.",
                    Patterns::Double(0.1, 100.));
  prm.add_parameter("Padding", padding,
                    "Distance from the image to the border of the simulation grid, where u = 0, on "
                    "all sides. Units: mm.",
                    Patterns::Double(0., 1000.));
  prm.add_parameter("Border", border,
                    "What surrounds the image. padded: the labels at the border of the image "
                    "continue to the border of the grid, and move, as in the paper. fixed: u = 0 "
                    "on and beyond the faces of the image that tissue touches. automatic: padded "
                    "if tissue is fixed to a chest, fixed if it slides or there is no chest.",
                    one_of(border_names()));
  prm.add_parameter("Background stiffness", background_stiffness,
                    "Stiffness of air over that of the softest tissue. A simulation that diverges "
                    "raises it, to 0.1 at most. Units: none.",
                    Patterns::Double(1e-4, 1.));
  prm.add_parameter("Map spacing", map_spacing,
                    "Spacing of the grid that stores the material of the loaded image, over that "
                    "of the simulation grid. Units: none.",
                    Patterns::Double(0.05, 4.));
  prm.add_parameter("Damping rate", damping_rate,
                    "r/rho, damping coefficient over density (paper eq. 1). 0: twice the lowest "
                    "frequency, estimated from the motion. Units: 1/s.",
                    Patterns::Double(0., 1e6));
  prm.add_parameter("Contact", contact,
                    "How nodes that slide are kept on the chest wall. projection: they are put "
                    "back on it after each step. gradual: they approach it with a limited speed, "
                    "the paper's eq. 11.",
                    one_of(contact_method_names()));
  prm.add_parameter("Correction part", correction_part,
                    "p of the paper's eq. 11: fraction of the distance to the chest wall that the "
                    "gradual contact corrects in a step. Units: none.",
                    Patterns::Double(1e-9, 1.));
  prm.add_parameter("Speed limit", speed_limit,
                    "v_max of the paper's eq. 11: the gradual contact corrects nodes that approach "
                    "the chest wall faster than this less. Units: mm/s.",
                    Patterns::Double(1e-6, 1e9));
  declare(prm, {"map w, through which the material is pulled back,",
                "w <- w + min(1, n h/tau) (u - w)", "w <- u", "max |w - u| in the tissue",
                "stiffer air or a longer lag, a smaller time step and a slower ramp"});
}

} // namespace prosup::fdm
