#ifndef PROSUP_MECHANICS_LAW_LIST_H
#define PROSUP_MECHANICS_LAW_LIST_H

#include "prosup/mechanics/laws/neo_hookean.h"
#include "prosup/mechanics/laws/yeoh.h"
#ifdef PROSUP_OWN_LAW
#include "prosup/mechanics/laws/own_law.h"
#endif

namespace prosup::mechanics {

template <typename... L>
struct LawList {};

/// All material laws. Parameters, kernels and solvers are made for those in this list; the first
/// is the default. One of the user's own may be added when prosup is built (PROSUP_OWN_LAW, see
/// examples/law).
#ifdef PROSUP_OWN_LAW
using Laws = LawList<NeoHookean, Yeoh, OwnLaw>;
#else
using Laws = LawList<NeoHookean, Yeoh>;
#endif

} // namespace prosup::mechanics

#endif
