#include "searched_property.h"

#include <cmath>

namespace prosup::registration {

namespace {

// Stiffness of a cut beyond which a layer of some ten mm of tissue follows, Pa/mm, and the share
// k0/(k0 + k) of one that is as good as fixed.
constexpr double usual_cut = 40., stiffest_cut = 0.004;

// Of these shares of one patient, whose cuts go through the same tissue.
constexpr double cuts_alike = 0.2;

constexpr double usual_skin = 8000.; // Pa mm

constexpr double degree = 3.14159265358979323846 / 180.;

/// An angle of the tilt. Patients lie tilted by some degrees: 5 to 10 in the pairs looked at.
template <typename Get, typename Set>
SearchedProperty angle(Get get, Set set) {
  return {"gravity",     get,          set, 4. * degree, 8. * degree,
          -25. * degree, 25. * degree, 0.,  6. * degree};
}

/// The stiffness of the cut planes of a position as k0/(k0 + k): what gives way is linear in 1/k
/// where hardly anything does.
template <Position position>
SearchedProperty cut_plane() {
  using P = MechanicalProperties;
  return {"cut plane stiffness",
          [](const P& p) { return usual_cut / (usual_cut + p.cut_plane_stiffness[position]); },
          [](P& p, double q) { p.cut_plane_stiffness[position] = usual_cut * (1. - q) / q; },
          -0.07,
          0.25,
          stiffest_cut,
          0.97,
          0.5,
          1.,
          true,
          false,
          position == Position::supine ? cuts_alike : 0.};
}

} // namespace

// Priors. Shear modulus: 100 to 1000 Pa were found in vivo from gravity (Eiben et al. 2016, Han et
// al. 2014), far below those of excised tissue. Poisson's ratio: tissue changes its volume by
// little, while blood and water leave. Gland over fat: 1 to 5 (Ramiao et al. 2016). Springs: the
// shear modulus over a layer of fascia of some ten mm; beyond a cut, tissue gives way by mu to
// (lambda + 2 mu) over its width, or hardly at all over bone. Skin: about 1.5 mm (Huang et al.
// 2008) of some kPa at small strains.
const std::vector<SearchedProperty>& searched_properties() {
  using P = MechanicalProperties;
  static const std::vector<SearchedProperty> all{
      {"shear modulus", [](const P& p) { return std::log(p.tissue.shear_modulus); },
       [](P& p, double q) { p.tissue.shear_modulus = std::exp(q); }, 0.1, 0.7, std::log(10.),
       std::log(1e5), std::log(300.), 0.7},
      // log(1 - 2 nu): the bulk modulus over the shear modulus is 1/(1 - 2 nu) - 1/3
      {"Poisson ratio", [](const P& p) { return std::log(1. - 2. * p.tissue.poisson_ratio); },
       [](P& p, double q) { p.tissue.poisson_ratio = 0.5 * (1. - std::exp(q)); }, -0.2, 0.7,
       std::log(0.02), std::log(0.5), std::log(0.06), 0.7},
      {"gland ratio", [](const P& p) { return std::log(p.tissue.gland_ratio); },
       [](P& p, double q) { p.tissue.gland_ratio = std::exp(q); }, 0.2, 0.7, std::log(0.3),
       std::log(10.), std::log(2.), 0.6},
      {"chest stiffness", [](const P& p) { return std::log(p.chest_stiffness); },
       [](P& p, double q) { p.chest_stiffness = std::exp(q); }, 0.2, 0.7, std::log(0.1),
       std::log(500.), std::log(8.), 1.2, true}, // low: tissue that slides freely
      {"lateral chest ratio", [](const P& p) { return std::log(p.lateral_chest_ratio); },
       [](P& p, double q) { p.lateral_chest_ratio = std::exp(q); }, -0.5, 1.5, std::log(1e-3),
       std::log(10.), std::log(0.3), 1.5, true, true}, // low: free at the side
      cut_plane<Position::prone>(),
      cut_plane<Position::supine>(),
      {"skin stiffness", [](const P& p) { return p.tissue.skin_stiffness / usual_skin; },
       [](P& p, double q) { p.tissue.skin_stiffness = q * usual_skin; }, 0.1, 0.5, 0., 10., 1., 1.,
       true}, // low: no skin
      angle([](const P& p) { return p.tilt.left; }, [](P& p, double q) { p.tilt.left = q; }),
      angle([](const P& p) { return p.tilt.superior; },
            [](P& p, double q) { p.tilt.superior = q; })};
  return all;
}

} // namespace prosup::registration
