#ifndef PROSUP_PHANTOM_GEOMETRY_H
#define PROSUP_PHANTOM_GEOMETRY_H

#include <deal.II/base/point.h>

namespace prosup::phantom {

using dealii::Point;

/// The unloaded shape of the paper's numerical phantom, LPS mm. The chest is a cylinder with
/// its axis along z. Its anterior side (-y) passes through the origin. The thickness of the
/// tissue on it, along y, is
///   t(x, z) = layer + height exp(-(x^2 + z^2) / (2 sigma^2)).
/// The tissue ends at the skin and in the cut planes x = +-width/2 and z = +-length/2. The
/// defaults give the extents and the volume (1.14 l) of the paper.
struct Geometry {
  double width = 160.4;       ///< extent from right to left (x), mm
  double length = 159.5;      ///< extent from inferior to superior (z), mm
  double chest_radius = 120.; ///< of the cylinder, mm
  double layer = 8.;          ///< tissue over the chest far from the breast, mm
  double height = 98.6;       ///< of the Gaussian, mm
  double sigma = 41.;         ///< standard deviation of the Gaussian, mm

  /// @throws Error if the chest is not wider than the tissue on it.
  void check() const;

  /// y of the chest, mm.
  double chest_y(double x) const;
  /// Of the tissue along y, mm.
  double thickness(double x, double z) const;
  /// y of the skin, mm.
  double skin_y(double x, double z) const { return chest_y(x) - thickness(x, z); }

  /// Whether a point lies between chest and skin and within width and length.
  bool in_tissue(const Point<3>& X) const;
  /// Distance from the skin of a point near it, mm, to first order; positive in the tissue.
  double depth(const Point<3>& X) const;
  /// Distance from the surface of the chest, mm; negative in the chest.
  double distance_to_chest(const Point<3>& x) const;

  /// The points of skin and chest with the x and z of `X`.
  Point<3> on_skin(const Point<3>& X) const { return {X[0], skin_y(X[0], X[2]), X[2]}; }
  Point<3> on_chest(const Point<3>& X) const { return {X[0], chest_y(X[0]), X[2]}; }

  /// Volume of the tissue, mm^3: the integral of the thickness, in closed form.
  double volume() const;
};

} // namespace prosup::phantom

#endif
