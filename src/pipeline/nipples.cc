#include "nipples.h"

#include <deal.II/base/utilities.h>

#include <charconv>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"

namespace prosup::pipeline {

using dealii::Point;

namespace {

constexpr double far_from_skin = 20.; // mm; more than a nipple is long and masks are off

std::string text_of(const Point<3>& p) {
  return format("%.1f, %.1f, %.1f", p[0], p[1], p[2]);
}

/// The point "X,Y,Z"; nothing if it is not three finite numbers.
std::optional<Point<3>> parsed(const std::string& text) {
  const std::vector<std::string> words = dealii::Utilities::split_string_list(text, ',');
  if (words.size() != 3)
    return {};
  Point<3> p;
  for (unsigned d = 0; d < 3; ++d) {
    const char* const last = words[d].data() + words[d].size();
    const auto [end, error] = std::from_chars(words[d].data(), last, p[d]);
    if (error != std::errc() || end != last || !std::isfinite(p[d]))
      return {};
  }
  return p;
}

/// The one that the user gives for a position.
std::optional<Point<3>> checked(const std::string& given, Position position, const StateMap& map) {
  if (given.empty())
    return {};
  const std::string option = std::string("'--") + name_of(position) + "-nipple'";
  const std::optional<Point<3>> nipple = parsed(given);
  if (!nipple)
    throw Error(option + " is '" + shown(given) +
                "' and not three finite numbers; give X,Y,Z in LPS, mm.");
  const mesh::TetMesh& mesh = map.mesh(position).mesh;
  const auto skin = evaluation::DepthGauge(mesh, mesh.points)(*nipple).skin;
  if (skin && *skin > far_from_skin)
    throw Error(option + " is " + text_of(*nipple) +
                format(", %.0f mm from the skin of the ", *skin) + name_of(position) +
                format(" breast, where at most %g mm can be; give it in LPS, mm.", far_from_skin));
  return nipple;
}

Point<3> carried(const Point<3>& nipple, Position from, const StateMap& map) {
  return map.mapper(other(from)).to_loaded(map.mapper(from).to_unloaded(nipple));
}

/// Of both loaded states.
PerPosition<std::optional<Point<3>>> loaded_nipples(const StateMap& map, const GivenNipples& given,
                                                    Remarks& remarks) {
  PerPosition<std::optional<Point<3>>> nipples;
  for (const Position position : both_positions)
    nipples[position] = checked(given[position], position, map);
  const bool found = !nipples.prone && !nipples.supine;
  if (found)
    nipples.prone = evaluation::tip_of(map.mesh(Position::prone).mesh);
  for (const Position position : both_positions)
    if (!nipples[position] && nipples[other(position)])
      nipples[position] = carried(*nipples[other(position)], other(position), map);
  if (found && nipples.prone)
    remarks.add("The nipple is taken to be the skin furthest from the chest in prone, (" +
                text_of(*nipples.prone) + "), which lies in supine at (" +
                text_of(*nipples.supine) + "); give --prone-nipple if it is elsewhere.");
  return nipples;
}

} // namespace

Nipples find_nipples(const StateMap& map, const GivenNipples& given, Remarks& remarks) {
  const auto loaded = loaded_nipples(map, given, remarks);
  const auto in = [&](const std::string& state, Position breast) {
    return loaded[breast] && state == unloaded_state
               ? map.mapper(breast).to_unloaded(*loaded[breast])
               : loaded[breast];
  };
  return {in(map.from(), map.breast_before()), in(map.to(), map.breast_after())};
}

} // namespace prosup::pipeline
