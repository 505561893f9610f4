#ifndef PROSUP_MECHANICS_BOUNDARY_H
#define PROSUP_MECHANICS_BOUNDARY_H

#include <functional>
#include <set>
#include <vector>

#include "prosup/mechanics/body/body.h"

namespace prosup::mechanics {

using BoundaryIds = std::set<dealii::types::boundary_id>;

/// Whether a boundary face with this centre (mm) and unit normal counts.
using FaceFilter =
    std::function<bool(const dealii::Tensor<1, 3>& centre, const dealii::Tensor<1, 3>& normal)>;

/// A number of a boundary face with this centre (mm) and unit normal.
using FaceValue =
    std::function<double(const dealii::Tensor<1, 3>& centre, const dealii::Tensor<1, 3>& normal)>;

/// Numbers, in Body::boundary_faces(), of the faces with one of `ids` that pass the filter, if
/// there is one. Local.
std::vector<std::size_t> faces_on_boundary(const Body& body, const BoundaryIds& ids,
                                           const FaceFilter& counts = {});

/// The value of each of these faces, in the configuration of the mesh. Local.
std::vector<double> values_at_faces(const Body& body, const std::vector<std::size_t>& faces,
                                    const FaceValue& value);

/// For each local node, whether it lies on a boundary face with one of `ids` that passes the
/// filter, if there is one. Collective.
std::vector<bool> nodes_on_boundary(const Body& body, const BoundaryIds& ids,
                                    const FaceFilter& counts = {});

/// The part of the area of a face with this many nodes that is lumped to its node `v`: a third of a
/// linear face at each corner; 1/12 at the corners and 1/4 at the edges of a quadratic one.
double area_part(std::size_t n_nodes, std::size_t v);

/// Area of the given boundary faces of this and other ranks, lumped to the local nodes, mm^2, with
/// nodes at `positions`. With `weights`, the area of each face counts as many times.
/// Collective.
std::vector<double> lumped_area(const Body& body, const std::vector<std::size_t>& faces,
                                const NodeVector& positions,
                                const std::vector<double>& weights = {});
/// The same for the boundary faces with one of `ids`. Collective.
std::vector<double> lumped_area(const Body& body, const BoundaryIds& ids,
                                const NodeVector& positions);

} // namespace prosup::mechanics

#endif
