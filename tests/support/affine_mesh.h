#ifndef PROSUP_TESTS_AFFINE_MESH_H
#define PROSUP_TESTS_AFFINE_MESH_H

#include "box_of_tets.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::tests {

/// x = A X + b, and its inverse.
struct AffineMap {
  dealii::Tensor<2, 3> A;
  dealii::Tensor<1, 3> b;

  dealii::Point<3> operator()(const dealii::Point<3>& X) const {
    return dealii::Point<3>(A * X + b);
  }
  dealii::Point<3> inverse(const dealii::Point<3>& x) const {
    return dealii::Point<3>(invert(A) * (x - b));
  }
};

/// Stretch, shear and shift, some millimetres over a box of 40 mm.
inline AffineMap stretch_and_shear() {
  return {dealii::Tensor<2, 3>({{1.1, 0.15, 0.}, {-0.1, 0.9, 0.05}, {0.02, 0., 1.05}}),
          dealii::Tensor<1, 3>({3., -5., 1.5})};
}

inline AffineMap other_stretch_and_shear() {
  return {dealii::Tensor<2, 3>({{0.95, -0.1, 0.05}, {0.12, 1.1, 0.}, {0., 0.08, 0.9}}),
          dealii::Tensor<1, 3>({-2., 4., -3.})};
}

/// A mesh that is `reference` when unloaded and map(reference) when loaded.
inline mesh::UnloadedMesh affine_mesh(const mesh::TetMesh& reference, const AffineMap& map) {
  mesh::UnloadedMesh result{reference, reference.points};
  for (auto& point : result.mesh.points)
    point = map(point);
  return result;
}

} // namespace prosup::tests

#endif
