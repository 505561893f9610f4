#ifndef PROSUP_TESTS_SUPPORT_VOXEL_BOX_H
#define PROSUP_TESTS_SUPPORT_VOXEL_BOX_H

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "prosup/core/error.h"
#include "prosup/fdm/breast_mesh.h"
#include "prosup/fdm/fdm_unloading.h"

namespace prosup::tests {

using dealii::Point;
using dealii::Tensor;

/// A box of tissue (label 2) under a chest (label 1), the lower face of which is
/// y = 0; towards -y is down.
struct VoxelBox {
  double voxel, width, depth, margin; ///< mm

  std::uint8_t label(const Point<3>& X) const {
    if (X[1] > 0.)
      return 1;
    return X[1] > -depth && std::abs(X[0]) < 0.5 * width && std::abs(X[2]) < 0.5 * width ? 2 : 0;
  }

  /// The labels of the box moved by a displacement, or where it is for none.
  image::LabelImage labels(const fdm::VectorField* displacement = nullptr) const {
    image::VoxelGrid grid;
    const double low[3] = {-0.5 * width - margin, -depth - margin, -0.5 * width - margin};
    const double high[3] = {0.5 * width + margin, margin, 0.5 * width + margin};
    for (unsigned d = 0; d < 3; ++d) {
      grid.size[d] = std::size_t(std::lround((high[d] - low[d]) / voxel));
      grid.spacing[d] = voxel;
      grid.origin[d] = low[d] + 0.5 * voxel;
    }
    image::LabelImage result(grid);
    for (std::size_t k = 0; k < grid.size[2]; ++k)
      for (std::size_t j = 0; j < grid.size[1]; ++j)
        for (std::size_t i = 0; i < grid.size[0]; ++i) {
          const Point<3> x = grid.physical(double(i), double(j), double(k));
          result(i, j, k) =
              label(displacement && x[1] <= 0. ? fdm::unloaded_position(*displacement, x) : x);
        }
    return result;
  }
};

/// What comes back of displacements by loading a box and unloading it through
/// voxels, as in the paper's appendix, mm.
struct BoxExperiment {
  settling::SettlingResult loading, unloading;
  double moves = 0., max_error = 0., p95_error = 0.;
};

inline BoxExperiment box_experiment(const fdm::FdmParameters& parameters, const VoxelBox& box,
                                    const fdm::Material& material, const Tensor<1, 3>& gravity,
                                    MPI_Comm communicator) {
  BoxExperiment result;
  fdm::FdmUnloading forward(parameters, {box.labels(), 1, material, gravity}, communicator);
  forward.hold_reference();
  result.loading = forward.run();
  const fdm::VectorField truth = forward.displacement();
  const image::LabelImage loaded = box.labels(&truth);
  fdm::FdmUnloading inverse(parameters, {loaded, 1, material, gravity}, communicator);
  result.unloading = inverse.run();
  const fdm::VectorField found = inverse.displacement();
  std::vector<double> errors;
  const auto& size = loaded.grid.size;
  for (std::size_t n = 0; n < loaded.values.size(); ++n) {
    if (loaded.values[n] != 2)
      continue;
    const Point<3> x = loaded.grid.physical(double(n % size[0]), double(n / size[0] % size[1]),
                                            double(n / size[0] / size[1]));
    const Point<3> X = fdm::unloaded_position(truth, x);
    errors.push_back(X.distance(fdm::unloaded_position(found, x)));
    result.moves = std::max(result.moves, X.distance(x));
  }
  std::sort(errors.begin(), errors.end());
  result.max_error = errors.back();
  result.p95_error = errors[errors.size() * 95 / 100];
  return result;
}

} // namespace prosup::tests

#endif
