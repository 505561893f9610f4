#ifndef PROSUP_TESTS_TEXTURED_PAIR_H
#define PROSUP_TESTS_TEXTURED_PAIR_H

#include <cmath>

#include "box.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mechanics/body/body.h"
#include "prosup/similarity/image_force.h"

namespace prosup::tests {

using dealii::Point;

/// A box of 40 x 48 x 56 mm as unloaded body, deformed by given maps x(X) into a prone and a supine
/// body with images of a smooth texture each.
class TexturedPair {
public:
  using Map = std::function<Point<3>(const Point<3>&)>;

  TexturedPair(const Map& prone, const Map& supine) {
    const auto reference = box([](const Point<3>& X) { return X; });
    for (const Position position : both_positions) {
      // The same topology has the same node numbers.
      unloaded[position] = reference->vertex_positions();
      unloaded[position].update_ghost_values();
      bodies[position] = box(position == Position::prone ? prone : supine);
      images[position] = texture(position);
    }
  }

  PerPosition<similarity::ImagedBody> imaged() const {
    return {{bodies.prone.get(), &unloaded.prone, &images.prone},
            {bodies.supine.get(), &unloaded.supine, &images.supine}};
  }

  static similarity::SimilarityDomain domain(double spacing, unsigned n_layers) {
    similarity::SimilarityDomain domain;
    domain.grid = image::grid_around(Point<3>(), Point<3>(40., 48., 56.), spacing, 12.);
    domain.no_air.assign(domain.grid.n_voxels(), false);
    domain.n_layers = n_layers;
    return domain;
  }

  PerPosition<std::unique_ptr<mechanics::Body>> bodies;
  PerPosition<mechanics::NodeVector> unloaded;
  PerPosition<image::ScalarImage> images;

private:
  static std::unique_ptr<mechanics::Body> box(const Map& map) {
    const auto mesh = make_box(MPI_COMM_WORLD, {4, 5, 6}, {40., 48., 56.}, map);
    return std::make_unique<mechanics::Body>(*mesh);
  }

  static image::ScalarImage texture(Position position) {
    const double phase = position == Position::prone ? 0. : 0.4;
    image::VoxelGrid grid = image::grid_around(Point<3>(), Point<3>(40., 48., 56.), 1., 30.);
    // Off the planes of the mesh: there the interpolant has kinks.
    grid.origin += dealii::Tensor<1, 3>({0.31, 0.43, 0.27});
    image::ScalarImage image(grid);
    for (std::size_t k = 0, v = 0; k < grid.size[2]; ++k)
      for (std::size_t j = 0; j < grid.size[1]; ++j)
        for (std::size_t i = 0; i < grid.size[0]; ++i, ++v) {
          const Point<3> x = grid.physical(double(i), double(j), double(k));
          image.values[v] =
              float(0.5 + 0.3 * std::sin(0.15 * x[0] + phase) * std::cos(0.12 * x[1]) +
                    0.2 * std::sin(0.1 * x[2] - 0.05 * x[0]));
        }
    return image;
  }
};

} // namespace prosup::tests

#endif
