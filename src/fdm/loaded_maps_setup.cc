// From labels to parts of the volume at the points of the grid.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "loaded_maps.h"
#include "prosup/fdm/trilinear_cell.h"

namespace prosup::fdm {

namespace {

/// For voxels of the chest, in place of a part.
constexpr unsigned not_counted = 255;

/// Where less than this part of the volume lies outside the chest, the material is unknown.
constexpr float least_known = 0.02f;

} // namespace

LoadedMaps::LoadedMaps(const image::LabelImage& labels, const std::vector<unsigned>& tissue_labels,
                       unsigned chest_label, double spacing, bool chest_is_soft)
    : tissue_labels_(tissue_labels) {
  const image::VoxelGrid& voxels = labels.grid;
  for (unsigned d = 0; d < 3; ++d) {
    low_[d] = std::numeric_limits<double>::max();
    high_[d] = -low_[d];
  }
  for (unsigned corner = 0; corner < 8; ++corner) {
    double index[3];
    for (unsigned d = 0; d < 3; ++d)
      index[d] = corner >> d & 1u ? double(voxels.size[d]) - 0.5 : -0.5;
    const Point<3> position = voxels.physical(index[0], index[1], index[2]);
    for (unsigned d = 0; d < 3; ++d) {
      low_[d] = std::min(low_[d], position[d]);
      high_[d] = std::max(high_[d], position[d]);
    }
  }
  grid_ = image::grid_around(low_, high_, spacing, 2. * spacing);
  average(labels, chest_label);
  normalise(chest_is_soft, grid_.voxel_volume());
  continue_beyond();
}

void LoadedMaps::average(const image::LabelImage& labels, unsigned chest_label) {
  const image::VoxelGrid& voxels = labels.grid;
  parts_.assign(tissue_labels_.size() + 1, std::vector<float>(grid_.n_voxels(), 0.f));
  values_.assign(grid_.n_voxels(), Values());
  std::array<unsigned, 256> part_of;
  part_of.fill(unsigned(tissue_labels_.size()));
  for (unsigned t = 0; t < tissue_labels_.size(); ++t)
    part_of[tissue_labels_[t]] = t;
  part_of[chest_label] = not_counted;

  // Voxels that are not small compared with the grid are cut.
  Index n_cuts;
  for (unsigned d = 0; d < 3; ++d)
    n_cuts[d] = std::max(1u, unsigned(std::ceil(2. * voxels.spacing[d] / grid_.spacing[0])));
  Index i;
  for (i[2] = 0; i[2] < voxels.size[2]; ++i[2])
    for (i[1] = 0; i[1] < voxels.size[1]; ++i[1])
      for (i[0] = 0; i[0] < voxels.size[0]; ++i[0]) {
        const unsigned part = part_of[labels(i[0], i[1], i[2])];
        if (part < tissue_labels_.size())
          note_touched_faces(voxels, i);
        spread(voxels, i, n_cuts, part);
      }
}

/// A voxel of tissue may be at the border of the image.
void LoadedMaps::note_touched_faces(const image::VoxelGrid& voxels, const Index& voxel) {
  for (unsigned d = 0; d < 3; ++d)
    for (unsigned side = 0; side < 2; ++side)
      if (voxel[d] == (side ? voxels.size[d] - 1 : 0)) {
        // The axis of the image that is axis e of LPS, if at right angles.
        for (unsigned e = 0; e < 3; ++e)
          if (std::abs(voxels.direction[e][d]) > 0.9)
            touched_[e][(voxels.direction[e][d] > 0.) == (side == 1)] = true;
      }
}

/// Adds the volume of a voxel, cut into parts, to the nodes around them.
void LoadedMaps::spread(const image::VoxelGrid& voxels, const Index& voxel, const Index& n_cuts,
                        unsigned part) {
  const std::size_t n = n_cuts[0] * n_cuts[1] * n_cuts[2];
  const float volume = float(voxels.voxel_volume() / double(n));
  for (std::size_t cut = 0; cut < n; ++cut) {
    const double at[3] = {double(cut % n_cuts[0]), double(cut / n_cuts[0] % n_cuts[1]),
                          double(cut / n_cuts[0] / n_cuts[1])};
    double index[3];
    for (unsigned d = 0; d < 3; ++d)
      index[d] = double(voxel[d]) - 0.5 + (at[d] + 0.5) / double(n_cuts[d]);
    const TrilinearCell cell(grid_, voxels.physical(index[0], index[1], index[2]));
    for (unsigned corner = 0; corner < 8; ++corner) {
      const float weight = volume * float(cell.weight(corner));
      (part == not_counted ? values_[cell.node(corner)].chest : parts_[part][cell.node(corner)]) +=
          weight;
    }
  }
}

void LoadedMaps::normalise(bool chest_is_soft, double full_weight) {
  const unsigned n_tissues = unsigned(tissue_labels_.size());
  std::vector<bool> known(grid_.n_voxels());
  for (std::size_t node = 0; node < grid_.n_voxels(); ++node) {
    float& chest = values_[node].chest;
    chest = std::min(1.f, chest / float(full_weight));
    float sum = 0.f, tissue = 0.f;
    for (unsigned t = 0; t <= n_tissues; ++t) {
      parts_[t][node] /= float(full_weight);
      sum += parts_[t][node];
      tissue += t < n_tissues ? parts_[t][node] : 0.f;
    }
    // Beyond the image there is nothing yet.
    float& air = parts_[n_tissues][node];
    air = std::max(0.f, 1.f - chest - tissue);
    if (chest_is_soft)
      air += chest;
    sum = tissue + air;
    known[node] = sum > least_known;
    if (!known[node]) { // deep in the chest: any material
      parts_[0][node] += 1.f;
      sum += 1.f;
    }
    for (unsigned t = 0; t <= n_tissues; ++t)
      parts_[t][node] /= sum;
    values_[node].tissue = 1.f - air / sum;
  }
  continue_into_chest(std::move(known));
}

void LoadedMaps::continue_into_chest(std::vector<bool> known) {
  // Two layers are felt by nodes that move. Without them material would jump there.
  for (unsigned layer = 0; layer < 2; ++layer) {
    const std::vector<bool> known_before = known;
    for (std::size_t node = 0; node < grid_.n_voxels(); ++node) {
      if (known_before[node])
        continue;
      std::vector<float> sum(parts_.size(), 0.f);
      float n = 0.f;
      for (int neighbour = 0; neighbour < 27; ++neighbour) {
        // The border of the grid is background or known, so that all are in memory.
        const std::size_t other =
            node + std::size_t(neighbour % 3) - 1 +
            grid_.size[0] * (std::size_t(neighbour / 3 % 3) - 1 +
                             grid_.size[1] * (std::size_t(neighbour / 9) - 1));
        if (other >= grid_.n_voxels() || !known_before[other])
          continue;
        ++n;
        for (std::size_t t = 0; t < parts_.size(); ++t)
          sum[t] += parts_[t][other];
      }
      if (n == 0.f)
        continue;
      known[node] = true;
      for (std::size_t t = 0; t < parts_.size(); ++t)
        parts_[t][node] = sum[t] / n;
      values_[node].tissue = 1.f - parts_.back()[node];
    }
  }
}

void LoadedMaps::continue_beyond() {
  // A body that ended at the image would run over the edge of the chest. Nodes within
  // one spacing of a face have seen less than their full volume.
  std::array<std::size_t, 3> first, last;
  for (unsigned d = 0; d < 3; ++d) {
    const double inner_low = (low_[d] - grid_.origin[d]) / grid_.spacing[d] + 1.;
    const double inner_high = (high_[d] - grid_.origin[d]) / grid_.spacing[d] - 1.;
    first[d] = std::size_t(std::ceil(inner_low));
    last[d] = std::max(first[d], std::size_t(inner_high));
  }
  std::array<std::size_t, 3> i;
  for (i[2] = 0; i[2] < grid_.size[2]; ++i[2])
    for (i[1] = 0; i[1] < grid_.size[1]; ++i[1])
      for (i[0] = 0; i[0] < grid_.size[0]; ++i[0]) {
        std::array<std::size_t, 3> from;
        for (unsigned d = 0; d < 3; ++d)
          from[d] = std::min(std::max(i[d], first[d]), last[d]);
        const std::size_t to = grid_.linear_index(i[0], i[1], i[2]);
        const std::size_t source = grid_.linear_index(from[0], from[1], from[2]);
        values_[to] = values_[source];
        for (auto& part : parts_)
          part[to] = part[source];
      }
}

} // namespace prosup::fdm
