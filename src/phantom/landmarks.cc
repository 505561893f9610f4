#include "prosup/phantom/landmarks.h"

#include <string>

#include "prosup/core/error.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/phantom/random.h"

namespace prosup::phantom {

using evaluation::Configuration;
using evaluation::Landmark;
using evaluation::MappedPoint;
using evaluation::PointMapper;

namespace {

constexpr unsigned draws_per_landmark = 1000; // before giving up

bool is_seen(const image::VoxelGrid& grid, const Point<3>& x) {
  const Point<3> index = grid.continuous_index(x);
  for (unsigned d = 0; d < 3; ++d)
    if (!(index[d] >= 0. && index[d] <= double(grid.size[d]) - 1.))
      return false;
  return true;
}

} // namespace

std::vector<Landmark> sample_landmarks(const Geometry& geometry,
                                       const PerPosition<mesh::UnloadedMesh>& meshes,
                                       const PerPosition<image::VoxelGrid>& grids,
                                       unsigned n_landmarks, std::uint64_t seed) {
  const PointMapper prone(meshes.prone), supine(meshes.supine);
  Random random(seed, Stream::landmarks);
  const double front = geometry.skin_y(0., 0.), back = geometry.chest_y(0.5 * geometry.width);
  std::vector<Landmark> landmarks;
  for (unsigned long draw = 0; landmarks.size() < n_landmarks; ++draw) {
    if (draw == static_cast<unsigned long>(draws_per_landmark) * n_landmarks)
      throw Error("The phantom's images show too little tissue in both positions for 'Phantom/"
                  "Landmarks' landmarks; choose a smaller 'Phantom/Images/Supine crop' or "
                  "'Rotation', or a larger 'Anterior margin' there.");
    const double x = (random.uniform() - 0.5) * geometry.width;
    const double y = front + random.uniform() * (back - front);
    const double z = (random.uniform() - 0.5) * geometry.length;
    const Point<3> X(x, y, z);
    if (!geometry.in_tissue(X))
      continue;
    const MappedPoint in_prone = prone.map(X, Configuration::unloaded),
                      in_supine = supine.map(X, Configuration::unloaded);
    if (in_prone.distance_outside == 0. && is_seen(grids.prone, in_prone.position) &&
        is_seen(grids.supine, in_supine.position))
      landmarks.push_back(
          {std::to_string(landmarks.size() + 1), in_prone.position, in_supine.position, X});
  }
  return landmarks;
}

} // namespace prosup::phantom
