#include "wall.h"

#include <algorithm>

namespace prosup::fdm {

Wall::Wall(const Slab& slab, const std::vector<float>& distance)
    : slab_(slab), leads_(slab.n_nodes()), first_{0} {
  const float h = float(slab.grid().spacing[0]);
  for (std::size_t node = 0; node < slab.n_nodes(); ++node)
    leads_[node] = distance[node] <= 0.5f * h;
  for (std::size_t node = slab.owned_begin(); node < slab.owned_end(); ++node) {
    if (!leads_[node] || slab.on_border(node))
      continue;
    float squares = 0.f;
    for (int i = 0; i < 27; ++i) {
      const std::size_t other = node + std::size_t(i % 3) - 1 +
                                slab.row() * (std::size_t(i / 3 % 3) - 1) +
                                slab.plane() * (std::size_t(i / 9) - 1);
      if (leads_[other] || slab.on_border(other))
        continue;
      squares += distance[other] * distance[other];
      neighbours_.push_back(other);
      weights_.push_back(distance[other]);
    }
    if (neighbours_.size() == first_.back())
      continue;
    // Neighbours across an edge or a corner of a cell may be deeper than h: weights above
    // those of a plane wall are not needed for accuracy, but would be unstable.
    const float own = std::max(distance[node], -h);
    for (std::size_t i = first_.back(); i < weights_.size(); ++i)
      weights_[i] *= own / squares;
    led_.push_back(node);
    first_.push_back(neighbours_.size());
  }
}

void Wall::lead(Dynamics& dynamics) const {
  for (NodalField& u : dynamics.displacement) {
    for (std::size_t n = 0; n < led_.size(); ++n) {
      Real sum = 0;
      for (std::size_t i = first_[n]; i < first_[n + 1]; ++i)
        sum += weights_[i] * u[neighbours_[i]];
      u[led_[n]] = sum;
    }
    slab_.exchange(u);
  }
}

} // namespace prosup::fdm
