#include <algorithm>
#include <cmath>

#include "scene_maps.h"

namespace prosup::registration {

namespace {

constexpr int longest_shift = 5;      // pixels, to either side
constexpr double least_overlap = 0.6; // of the smaller view

/// A picture and the part of it that counts.
struct Picture {
  std::array<int, 2> size;
  const std::vector<double>& values;
  std::vector<bool> known;
  std::array<int, 2> low{1 << 30, 1 << 30}, high{-1, -1}; // box of what is known
  std::size_t n_known = 0;

  template <typename Known>
  Picture(const FrontView& view, const std::vector<double>& v, const Known& is_known)
      : size(view.size), values(v), known(v.size()) {
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const std::size_t p = index(i, j);
        known[p] = is_known(p);
        if (!known[p])
          continue;
        ++n_known;
        low = {std::min(low[0], i), std::min(low[1], j)};
        high = {std::max(high[0], i), std::max(high[1], j)};
      }
  }

  std::size_t index(int i, int j) const {
    return std::size_t(j) * std::size_t(size[0]) + std::size_t(i);
  }
};

/// Where a pixel of one picture lies in the other, which may be turned over.
struct Placement {
  std::array<bool, 2> turned{};
  std::array<int, 2> shift{};
};

double correlation(const Picture& a, const Picture& b, const Placement& place) {
  double n = 0., sa = 0., sb = 0., saa = 0., sbb = 0., sab = 0.;
  for (int j = a.low[1]; j <= a.high[1]; ++j)
    for (int i = a.low[0]; i <= a.high[0]; ++i) {
      const std::size_t p = a.index(i, j);
      if (!a.known[p])
        continue;
      const int from[2] = {i, j};
      int to[2];
      for (unsigned d = 0; d < 2; ++d)
        to[d] = place.turned[d] ? place.shift[d] - from[d] : place.shift[d] + from[d];
      if (to[0] < 0 || to[1] < 0 || to[0] >= b.size[0] || to[1] >= b.size[1])
        continue;
      const std::size_t q = b.index(to[0], to[1]);
      if (!b.known[q])
        continue;
      const double x = a.values[p], y = b.values[q];
      n += 1., sa += x, sb += y, saa += x * x, sbb += y * y, sab += x * y;
    }
  if (n < least_overlap * double(std::min(a.n_known, b.n_known)) || n < 10.)
    return -1.;
  const double va = saa - sa * sa / n, vb = sbb - sb * sb / n;
  return va > 0. && vb > 0. ? (sab - sa * sb / n) / std::sqrt(va * vb) : 0.;
}

/// The best correlation of all shifts.
double best_correlation(const Picture& a, const Picture& b, std::array<bool, 2> turned) {
  Placement start{turned, {}};
  for (unsigned d = 0; d < 2; ++d) // centres of the boxes coincide
    start.shift[d] = turned[d] ? (a.low[d] + a.high[d] + b.low[d] + b.high[d]) / 2
                               : (b.low[d] + b.high[d] - a.low[d] - a.high[d]) / 2;
  double best = -1.;
  for (int j = -longest_shift; j <= longest_shift; ++j)
    for (int i = -longest_shift; i <= longest_shift; ++i) {
      Placement place = start;
      place.shift[0] += i;
      place.shift[1] += j;
      best = std::max(best, correlation(a, b, place));
    }
  return best;
}

Turned correlations(const Picture& a, const Picture& b) {
  return {best_correlation(a, b, {false, false}), best_correlation(a, b, {true, false}),
          best_correlation(a, b, {false, true}), best_correlation(a, b, {true, true})};
}

} // namespace

ViewFit fit_of(const FrontView& a, const FrontView& b) {
  const auto tissue = [](const FrontView& view) {
    return [&view](std::size_t p) { return view.tissue[p] > 0.; };
  };
  ViewFit fit;
  fit.tissue = correlations({a, a.tissue, tissue(a)}, {b, b.tissue, tissue(b)});
  fit.gland = correlations({a, a.gland, tissue(a)}, {b, b.gland, tissue(b)});
  return fit;
}

} // namespace prosup::registration
