#include "profiles.h"

#include <algorithm>
#include <cmath>

#include "prosup/image/sampling.h"

namespace prosup::prepare {

float ProfileSource::scaled(float intensity) const {
  if (is_ct)
    return std::clamp(intensity, -180.f, 80.f) / 150.f;
  return std::log(std::max(intensity, 0.f) + 2.f * float(std::max(air, 1e-3)));
}

Profiles sample_profiles(const ProfileSource& source, const TrunkGrid& grid, const ColumnMap& start,
                         double step, std::size_t n_samples) {
  Profiles profiles;
  profiles.grid = grid;
  profiles.start = start;
  profiles.step = step;
  profiles.n_samples = n_samples;
  const std::size_t n = grid.n_rows * grid.n_columns * n_samples;
  profiles.u.assign(n, 0.f);
  profiles.known.assign(n, 0);
  profiles.is_body.assign(n, 0);
  const image::Sampler sampler(source.image);
  std::size_t at = 0;
  for (std::size_t r = 0; r < grid.n_rows; ++r)
    for (std::size_t c = 0; c < grid.n_columns; ++c)
      for (std::size_t i = 0; i < n_samples; ++i, ++at) {
        const Point<3> p =
            grid.axis.position(profiles.radius(r, c, double(i)), grid.angle(c), grid.z(r));
        if (!sampler.inside(p))
          continue;
        profiles.known[at] = 1;
        profiles.u[at] = source.scaled(sampler.value(p));
        profiles.is_body[at] = image::nearest_label(source.body, p) != 0;
      }
  return profiles;
}

double RunningSum::operator()(long first, long end) const {
  const long n = long(sums_.size()) - 1;
  first = std::clamp(first, 0l, n);
  end = std::clamp(end, first, n);
  return sums_[std::size_t(end)] - sums_[std::size_t(first)];
}

} // namespace prosup::prepare
