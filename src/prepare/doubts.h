#ifndef PROSUP_SRC_PREPARE_DOUBTS_H
#define PROSUP_SRC_PREPARE_DOUBTS_H

#include "prosup/prepare/chest_wall.h"
#include "prosup/prepare/preparation.h"
#include "prosup/prepare/tissues.h"

namespace prosup::prepare {

/// How sure chest wall and tissues are, with a doubt for whatever is not as it should be.
Confidence judge(const ChestWall& wall, const Tissues& tissues);

} // namespace prosup::prepare

#endif
