#ifndef PROSUP_SRC_PIPELINE_NIPPLES_H
#define PROSUP_SRC_PIPELINE_NIPPLES_H

#include <optional>

#include "prosup/pipeline/commands.h"
#include "state_map.h"

namespace prosup::pipeline {

/// The nipple in the state that points come from and in that they are mapped to, LPS, mm; nothing
/// for meshes that do not tell skin and chest wall, if it is not given.
struct Nipples {
  std::optional<dealii::Point<3>> before, after;
};

/// Those that are given, and for the others where these are mapped to. If none is given it is the
/// skin furthest from the chest in prone, where the breast hangs; this is said.
/// @throws Error if one is not three finite numbers, or if it is far from the skin.
Nipples find_nipples(const StateMap& map, const GivenNipples& given, Remarks& remarks);

} // namespace prosup::pipeline

#endif
