#ifndef PROSUP_SIMILARITY_ELEMENT_SAMPLES_H
#define PROSUP_SIMILARITY_ELEMENT_SAMPLES_H

#include <vector>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/static/elastic_metric.h"
#include "prosup/similarity/samples.h"
#include "prosup/similarity/voxel_map.h"

namespace prosup::similarity {

/// A body of finite elements, its unloaded positions, and the image of its loaded configuration;
/// all null on ranks that do not work on it.
struct ImagedBody {
  const mechanics::Body* body = nullptr;
  const mechanics::NodeVector* unloaded = nullptr; ///< X with ghosts, mm
  const image::ScalarImage* image = nullptr;       ///< of the loaded body
};

/// The image of a body at the voxels of a grid around its unloaded mesh, and the way back: forces
/// on voxels become nodal forces. Construction is collective on the communicator of the body.
class ElementSamples {
public:
  /// Does nothing if the body is null. `excluded` as in SimilarityDomain, of this body; may be
  /// null or empty.
  ElementSamples(const SimilarityDomain& domain, const ImagedBody& imaged,
                 const image::LabelImage* excluded);

  const Samples& samples() const { return samples_; }

  /// Replaces the gradients grad_x P by those g of the given variable: F F^T grad_x P or
  /// -F^T grad_x P. Once, before forces() and stiffness().
  void derive_by(Variable variable);

  /// -dS/du_a or -dS/dX_a of owned nodes for dS/dP_v = `slope`, [S]/mm:
  ///   f_a = -sum_v slope_v N_a(X_v) g_v.
  /// Collective; empty without a body.
  mechanics::NodeVector forces(const std::vector<float>& slope) const;

  /// sum_v curvature_v N_a N_b g_v g_v^T of each cell of this rank, [S]/mm^2: the part of the
  /// second derivative that Gauss-Newton keeps.
  std::vector<mechanics::CellStiffness> stiffness(const std::vector<float>& curvature) const;

private:
  void add_unknown(const SimilarityDomain& domain, const VoxelMap& map);

  ImagedBody imaged_;
  std::vector<VoxelMap::Voxel> voxels_;
  Samples samples_; // of these voxels, and then of those beyond cuts
};

} // namespace prosup::similarity

#endif
