#include "labelling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundary_faces.h"
#include "prosup/image/sampling.h"

namespace prosup::mesh {

namespace {

using Vector = dealii::Tensor<1, 3>;

bool contains(const std::vector<unsigned>& labels, unsigned label) {
  return std::find(labels.begin(), labels.end(), label) != labels.end();
}

/// Barycentric coordinates of 35 points spread evenly over a tetrahedron: the
/// centres of the nodes of a lattice with five of them along each edge.
std::vector<std::array<double, 4>> sample_weights() {
  std::vector<std::array<double, 4>> weights;
  for (int a = 0; a < 5; ++a)
    for (int b = 0; a + b < 5; ++b)
      for (int c = 0; a + b + c < 5; ++c) {
        const int d = 4 - a - b - c;
        weights.push_back({(a + 0.25) / 5., (b + 0.25) / 5., (c + 0.25) / 5., (d + 0.25) / 5.});
      }
  return weights;
}

/// Label of the tissue voxel whose centre is nearest to x, among larger and larger cubes.
std::uint8_t nearest_tissue(const image::LabelImage& labels, const Point<3>& x,
                            const std::vector<unsigned>& tissue_labels) {
  const Point<3> index = labels.grid.continuous_index(x);
  const auto largest =
      long(std::max({labels.grid.size[0], labels.grid.size[1], labels.grid.size[2]}));
  double nearest = std::numeric_limits<double>::infinity();
  std::uint8_t result = std::uint8_t(tissue_labels.front());
  for (long radius = 1; radius <= largest && nearest == std::numeric_limits<double>::infinity();
       radius *= 2) {
    long begin[3], end[3];
    for (unsigned d = 0; d < 3; ++d) {
      begin[d] = std::clamp(long(std::floor(index[d])) - radius, 0l, long(labels.grid.size[d]));
      end[d] = std::clamp(long(std::floor(index[d])) + radius + 2, 0l, long(labels.grid.size[d]));
    }
    for (long k = begin[2]; k < end[2]; ++k)
      for (long j = begin[1]; j < end[1]; ++j)
        for (long i = begin[0]; i < end[0]; ++i) {
          const double distance = x.distance(labels.grid.physical(double(i), double(j), double(k)));
          const std::uint8_t label = labels(std::size_t(i), std::size_t(j), std::size_t(k));
          if (distance < nearest && contains(tissue_labels, label)) {
            nearest = distance;
            result = label;
          }
        }
  }
  return result;
}

/// Whether the three corners lie in one outer face of the image.
bool in_image_border(const std::array<Point<3>, 3>& corners, const image::VoxelGrid& grid) {
  std::array<Point<3>, 3> index;
  for (unsigned a = 0; a < 3; ++a)
    index[a] = grid.continuous_index(corners[a]);
  for (unsigned d = 0; d < 3; ++d)
    for (const double border : {-0.5, double(grid.size[d]) - 0.5})
      if (std::all_of(index.begin(), index.end(),
                      [&](const Point<3>& i) { return std::abs(i[d] - border) < 1e-6; }))
        return true;
  return false;
}

/// The first label on the way along the outward normal that is no tissue. Where
/// tissue goes on for a few voxels (rounded edges lie inside the mask), the skin.
std::uint8_t label_beyond(const std::array<Point<3>, 3>& corners, const image::LabelImage& labels,
                          const std::vector<unsigned>& tissue_labels) {
  const Point<3> centroid((corners[0] + corners[1] + corners[2]) / 3.);
  Vector normal = cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
  normal /= normal.norm();
  const auto& spacing = labels.grid.spacing;
  const double step = 0.25 * std::min({spacing[0], spacing[1], spacing[2]});
  const double farthest = 3. * std::max({spacing[0], spacing[1], spacing[2]});
  for (double distance = 0.; distance <= farthest; distance += step) {
    const std::uint8_t label = image::nearest_label(labels, centroid + distance * normal);
    if (!contains(tissue_labels, label))
      return label;
  }
  return 0;
}

} // namespace

std::vector<std::uint8_t> sample_tissue(const TetMesh& mesh, const image::LabelImage& labels,
                                        const std::vector<unsigned>& tissue_labels) {
  static const auto weights = sample_weights();
  std::vector<std::uint8_t> tissue;
  tissue.reserve(mesh.cells.size());
  for (const auto& cell : mesh.cells) {
    std::array<unsigned, 256> votes{};
    Point<3> centroid;
    for (const unsigned node : cell)
      centroid += 0.25 * Vector(mesh.points[node]);
    for (const auto& w : weights) {
      Point<3> x;
      for (unsigned a = 0; a < 4; ++a)
        x += w[a] * Vector(mesh.points[cell[a]]);
      ++votes[image::nearest_label(labels, x)];
    }
    unsigned best = tissue_labels.front();
    for (const unsigned label : tissue_labels)
      if (votes[label] > votes[best])
        best = label;
    tissue.push_back(votes[best] > 0 ? std::uint8_t(best)
                                     : nearest_tissue(labels, centroid, tissue_labels));
  }
  return tissue;
}

std::vector<BoundaryFace> find_boundary(const TetMesh& mesh, const image::LabelImage& labels,
                                        const Labels& meaning) {
  std::vector<BoundaryFace> result;
  for (const OuterFace& face : outer_faces(mesh)) {
    const std::array<Point<3>, 3> corners{mesh.points[face.nodes[0]], mesh.points[face.nodes[1]],
                                          mesh.points[face.nodes[2]]};
    BoundaryPart part = BoundaryPart::cut_plane;
    if (!in_image_border(corners, labels.grid)) {
      const unsigned beyond = label_beyond(corners, labels, meaning.tissues);
      if (beyond == meaning.chest)
        part = BoundaryPart::chest_wall;
      else if (beyond == 0 || beyond != meaning.unknown)
        part = BoundaryPart::skin;
    }
    result.push_back({face.nodes, part});
  }
  return result;
}

} // namespace prosup::mesh
