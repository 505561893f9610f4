#include "prosup/prepare/contrast.h"

#include <algorithm>

namespace prosup::prepare {

const std::vector<std::string>& contrast_names() {
  static const std::vector<std::string> names{"t1", "t1fs", "t2", "ct"};
  return names;
}

std::string describe(Contrast contrast) {
  switch (contrast) {
  case Contrast::t1:
    return "MR with bright fat (T1)";
  case Contrast::t1_fat_suppressed:
    return "MR with suppressed fat (T1)";
  case Contrast::t2:
    return "MR with bright fat (T2)";
  default:
    return "CT";
  }
}

namespace {
constexpr float thin_air = -500.f; // Hounsfield units
} // namespace

bool has_air_of_ct(const image::ScalarImage& image) {
  return std::any_of(image.values.begin(), image.values.end(),
                     [](float value) { return value < thin_air; });
}

bool looks_like_ct(const image::ScalarImage& image) {
  constexpr float padding = -1100.f;
  constexpr double least_share = 0.02;
  const auto n_air = std::count_if(image.values.begin(), image.values.end(),
                                   [](float value) { return value > padding && value < thin_air; });
  return double(n_air) > least_share * double(image.values.size());
}

} // namespace prosup::prepare
