#include "prosup/phantom/texture.h"

#include <algorithm>
#include <cmath>

namespace prosup::phantom {

namespace {

struct Intensities {
  double air, muscle, rib, lung, fat, gland, skin, septum;
  double fat_variation, gland_variation, muscle_variation; // standard deviations
};

const Intensities& intensities(Modality modality) {
  static const Intensities mr{0., 75., 35., 12., 205., 95., 110., 120., 10., 13., 5.};
  static const Intensities ct{-1000., 55., 400., -820., -105., 35., 20., -30., 8., 12., 6.};
  return modality == Modality::mr ? mr : ct;
}

// Lattice spacings of the random functions, mm.
constexpr double fat_size = 5., septa_size = 11., muscle_size = 4.;
constexpr double septum_level = 0.09;  // |septa function| within the septa
constexpr double skin_thickness = 1.6; // mm
constexpr double gland_edge = 0.25;    // width of the edge of the gland, in levels
// Depth in the chest, mm, of muscle and rib cage; size and distance of the ribs.
constexpr double rib_depth = 19., rib_half_depth = 5., rib_half_height = 6.5, rib_distance = 25.,
                 rib_slope = 0.35, lung_depth = 26.;

double mix(double a, double b, double weight) {
  return a + weight * (b - a);
}

} // namespace

const std::vector<std::string>& modality_names() {
  static const std::vector<std::string> names{"MR", "CT"};
  return names;
}

Texture::Texture(const Anatomy& anatomy, std::uint64_t seed)
    : anatomy_(anatomy), fat_(fat_size, seed, Stream::fat_texture),
      septa_(septa_size, seed, Stream::septa), muscle_(muscle_size, seed, Stream::muscle) {}

double Texture::tissue(Modality modality, const Point<3>& X) const {
  const Intensities& of = intensities(modality);
  if (anatomy_.geometry().depth(X) < skin_thickness)
    return of.skin;
  const double variation = fat_(X), septum = septa_(X) / septum_level;
  const double fat = mix(of.fat + of.fat_variation * variation, of.septum,
                         0.75 * std::exp(-0.5 * septum * septum));
  const double in_gland = std::clamp(0.5 + anatomy_.gland_level(X) / gland_edge, 0., 1.);
  return mix(fat, of.gland + of.gland_variation * variation, in_gland);
}

double Texture::chest(Modality modality, const Point<3>& x) const {
  const Intensities& of = intensities(modality);
  const double depth = -anatomy_.geometry().distance_to_chest(x);
  // Ribs slope downwards from the side to the front.
  const double along = (x[2] - rib_slope * std::abs(x[0])) / rib_distance;
  const double off = rib_distance * (along - std::round(along));
  if (std::hypot((depth - rib_depth) / rib_half_depth, off / rib_half_height) < 1.)
    return of.rib;
  return depth > lung_depth ? of.lung : of.muscle + of.muscle_variation * muscle_(x);
}

double Texture::air(Modality modality) const {
  return intensities(modality).air;
}

} // namespace prosup::phantom
