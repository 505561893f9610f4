#include "shown_properties.h"

namespace prosup::pipeline {

const std::vector<ShownProperty>& shown_properties() {
  using P = registration::MechanicalProperties;
  static const std::vector<ShownProperty> all{
      {"/shear_modulus", "Shear modulus", "Pa", [](const P& p) { return p.tissue.shear_modulus; }},
      {"/poisson_ratio", "Poisson's ratio", "", [](const P& p) { return p.tissue.poisson_ratio; }},
      {"/gland_ratio", "Gland over fat", "", [](const P& p) { return p.tissue.gland_ratio; }},
      {"/skin_stiffness", "Skin stiffness", "Pa mm",
       [](const P& p) { return p.tissue.skin_stiffness; }},
      {"/chest_stiffness", "Springs on the chest wall", "Pa/mm",
       [](const P& p) { return p.chest_stiffness; }},
      {"/lateral_chest_ratio", "Springs at the side over those in front", "",
       [](const P& p) { return p.lateral_chest_ratio; }},
      {"/cut_plane_stiffness/prone", "Springs on cut planes of prone", "Pa/mm",
       [](const P& p) { return p.cut_plane_stiffness.prone; }},
      {"/cut_plane_stiffness/supine", "Springs on cut planes of supine", "Pa/mm",
       [](const P& p) { return p.cut_plane_stiffness.supine; }}};
  return all;
}

} // namespace prosup::pipeline
