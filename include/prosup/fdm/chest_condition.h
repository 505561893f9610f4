#ifndef PROSUP_FDM_CHEST_CONDITION_H
#define PROSUP_FDM_CHEST_CONDITION_H

namespace prosup::fdm {

/// How tissue may move on the chest.
enum class ChestContact {
  fixed,    ///< not at all: u = 0 in the chest
  sliding,  ///< along its surface
  one_sided ///< along its surface and away from it
};

/// What the chest does to the tissue on it.
struct ChestCondition {
  ChestContact contact = ChestContact::fixed;
  double spring_stiffness = 0.; ///< of springs that resist sliding, Pa/mm
};

} // namespace prosup::fdm

#endif
