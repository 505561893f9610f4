#ifndef PROSUP_FDM_MATERIAL_H
#define PROSUP_FDM_MATERIAL_H

#include <map>

namespace prosup::fdm {

/// Lame parameters of a neo-Hookean tissue, Pa.
struct LameParameters {
  double mu;
  double lambda;
};

/// The stiffness of the tissues of a breast.
struct Material {
  std::map<unsigned, LameParameters> tissues; ///< by label
};

} // namespace prosup::fdm

#endif
