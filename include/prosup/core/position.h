#ifndef PROSUP_CORE_POSITION_H
#define PROSUP_CORE_POSITION_H

#include <array>

namespace prosup {

/// How the patient lies in an image.
enum class Position { prone, supine };

inline constexpr std::array<Position, 2> both_positions{Position::prone, Position::supine};

constexpr Position other(Position position) {
  return position == Position::prone ? Position::supine : Position::prone;
}

/// "prone" or "supine", as in parameters and file names.
constexpr const char* name_of(Position position) {
  return position == Position::prone ? "prone" : "supine";
}

/// One value for prone and one for supine.
template <typename T>
struct PerPosition {
  T prone{}, supine{};

  T& operator[](Position position) { return position == Position::prone ? prone : supine; }
  const T& operator[](Position position) const {
    return position == Position::prone ? prone : supine;
  }
};

} // namespace prosup

#endif
