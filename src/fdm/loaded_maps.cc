#include "loaded_maps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "prosup/fdm/trilinear_cell.h"

namespace prosup::fdm {

void LoadedMaps::set_material(const Material& material, double stiffness) {
  std::vector<LameParameters> all;
  LameParameters softest{std::numeric_limits<double>::max(), 0.};
  for (const unsigned label : tissue_labels_) {
    all.push_back(material.tissues.at(label));
    if (all.back().mu < softest.mu)
      softest = all.back();
  }
  all.push_back({stiffness * softest.mu, stiffness * softest.lambda});
  // The geometric mean: by the arithmetic one a layer of air as thick as the grid is
  // wide is nearly as stiff as the tissue next to it, and the body too thick.
  for (std::size_t node = 0; node < grid_.n_voxels(); ++node) {
    double mu = 0., lambda = 0., tissue = 0.;
    for (std::size_t t = 0; t + 1 < all.size(); ++t) {
      tissue += parts_[t][node];
      mu += parts_[t][node] * all[t].mu;
      lambda += parts_[t][node] * all[t].lambda;
    }
    const double air = 1. - tissue;
    const double floor = 1e-6;
    values_[node].mu = float(std::pow(std::max(mu, floor) / std::max(tissue, floor), tissue) *
                             std::pow(all.back().mu, air));
    values_[node].lambda =
        float(std::pow(std::max(lambda, floor) / std::max(tissue, floor), tissue) *
              std::pow(all.back().lambda, air));
  }
}

LoadedMaps::Values LoadedMaps::values(const Point<3>& position) const {
  const TrilinearCell cell(grid_, position);
  float sum[8] = {0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const float weight = float(cell.weight(corner));
    const Values& at = values_[cell.node(corner)];
    const float all[8] = {at.mu,       at.lambda,   at.tissue,   at.chest,
                          at.force[0], at.force[1], at.force[2], at.unused};
    for (unsigned i = 0; i < 8; ++i)
      sum[i] += weight * all[i];
  }
  return {sum[0], sum[1], sum[2], sum[3], {sum[4], sum[5], sum[6]}, sum[7]};
}

void LoadedMaps::set_force(std::size_t node, const Tensor<1, 3>& force) {
  for (unsigned c = 0; c < 3; ++c)
    values_[node].force[c] = float(force[c]);
}

} // namespace prosup::fdm
