#ifndef PROSUP_SRC_PREPARE_FAT_SIGN_H
#define PROSUP_SRC_PREPARE_FAT_SIGN_H

#include "profiles.h"

namespace prosup::prepare {

/// (n- - n+)/(n- + n+) of the tissue in front of the trunk that is darker (n-) and brighter (n+)
/// than the fat below the skin, as in FatSign; 0 if there is none.
double darker_than_fat(const ProfileSource& source, const TrunkAxis& axis);

} // namespace prosup::prepare

#endif
