#ifndef PROSUP_SIMILARITY_CUT_SURFACES_H
#define PROSUP_SIMILARITY_CUT_SURFACES_H

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <cstddef>
#include <vector>

#include "prosup/mechanics/body/body.h"

namespace prosup::similarity {

/// Where the faces at which the border of an image cut a body off lie in the unloaded state. The
/// image does not know what is beyond them: no air, in any case. Faces of one side of the image are
/// one surface, a height over the plane of that side, which goes on beyond the faces.
class CutSurfaces {
public:
  /// The columns of `axes` are those of the image. Collective on the communicator of the body.
  CutSurfaces(const mechanics::Body& body, const mechanics::NodeVector& unloaded,
              const dealii::Tensor<2, 3>& axes);

  bool empty() const { return surfaces_.empty(); }
  /// Whether an unloaded position lies beyond one of them.
  bool beyond(const dealii::Point<3>& X) const;

private:
  /// Mean heights in square cells of the plane that has the normal `up`.
  struct Surface {
    dealii::Tensor<1, 3> up, along[2];
    double low[2];
    std::size_t size[2];
    std::vector<double> heights;
    double lowest, highest; ///< of them

    Surface(const std::vector<dealii::Point<3>>& points, const dealii::Tensor<1, 3>& up,
            const dealii::Tensor<1, 3>& first, const dealii::Tensor<1, 3>& second);
    /// The cell nearest to X along one of the two axes.
    std::size_t cell(const dealii::Point<3>& X, unsigned axis) const;
    double& height(const dealii::Point<3>& X);
    double height(const dealii::Point<3>& X) const;
    /// Most voxels are above or below all heights, so that theirs is not looked up.
    bool is_passed_by(const dealii::Point<3>& X) const {
      const double at = X * up;
      return at > lowest && (at > highest || at > height(X));
    }
    void fill_gaps(std::vector<bool> known);
  };

  std::vector<Surface> surfaces_;
};

} // namespace prosup::similarity

#endif
