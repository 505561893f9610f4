#ifndef PROSUP_MECHANICS_LAW_LIST_H
#define PROSUP_MECHANICS_LAW_LIST_H

#include "prosup/mechanics/laws/neo_hookean.h"
#include "prosup/mechanics/laws/yeoh.h"

namespace prosup::mechanics {

template <typename... L>
struct LawList {};

/// All material laws. Parameters, kernels and solvers are made for those in this list; the first
/// is the default.
using Laws = LawList<NeoHookean, Yeoh>;

} // namespace prosup::mechanics

#endif
