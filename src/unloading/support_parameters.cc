#include "prosup/unloading/support_parameters.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

#include "prosup/core/parameters.h"
#include "prosup/image/sampling.h"
#include "prosup/mesh/tet_mesh.h"
#include "prosup/unloading/chest_surface.h"

namespace prosup::unloading {

using namespace dealii;
using mechanics::Body;
using mechanics::ContactLaw;
using mechanics::ContactMethod;
using mechanics::FaceFilter;
using mechanics::node_value;
using mechanics::Supports;

namespace {

constexpr auto chest_wall = mesh::boundary_id_of(mesh::BoundaryPart::chest_wall);
constexpr auto cut_plane = mesh::boundary_id_of(mesh::BoundaryPart::cut_plane);

constexpr double farthest_slide = 25.; // mm, beyond the nodes on the chest

// The mesh follows no bump of the chest that is smaller than its edges, and a node that slides over
// one flutters.
constexpr double smoothing_in_edges = 0.5;

// Slope of the smoothed distance across a face of the base, 1 on a smooth chest. Where it is less,
// on a sharp crest, at the edge of a sheet or where the mesh leaves the chest, the level sets do
// not tell in which directions the face may slide.
constexpr double least_slope = 0.5;

constexpr double least_alignment = 0.9; // of a cut face with the border it lies in

bool in_field_of_view(const image::VoxelGrid& grid, const Point<3>& x) {
  const Point<3> index = grid.continuous_index(x);
  bool all = true;
  for (unsigned d = 0; d < 3; ++d)
    all = all && index[d] >= -0.5 && index[d] <= double(grid.size[d]) - 0.5;
  return all;
}

/// Whether tissue beyond the border of the image holds a face that lies in it. Where the other
/// image shows air there is none: the tissue has moved across the border. Where the other image
/// does not reach, the face is taken to be held.
FaceFilter held_beyond(const image::LabelImage& other) {
  const auto& spacing = other.grid.spacing;
  const double step = 1.5 * std::max({spacing[0], spacing[1], spacing[2]});
  return [&other, step](const Tensor<1, 3>& centre, const Tensor<1, 3>& normal) {
    bool is_seen = false;
    for (const double distance : {-step, 0., step}) {
      const Point<3> x(centre + distance * normal);
      if (image::nearest_label(other, x) != 0)
        return true;
      is_seen = is_seen || in_field_of_view(other.grid, x);
    }
    return !is_seen;
  };
}

/// The edge of the regular triangle that has the mean area of the faces.
double mean_edge(const Body& body, const mechanics::BoundaryIds& ids) {
  double sums[2] = {0., 0.}; // area, faces
  for (const mechanics::BoundaryFace& face : body.boundary_faces()) {
    if (ids.count(face.id) == 0)
      continue;
    const auto corner = [&](unsigned v) {
      return node_value(body.vertex_positions(), face.nodes[v]);
    };
    sums[0] += 0.5 * cross_product_3d(corner(1) - corner(0), corner(2) - corner(0)).norm();
    sums[1] += 1.;
  }
  Utilities::MPI::sum(ArrayView<const double>(sums, 2), body.communicator(),
                      ArrayView<double>(sums, 2));
  return sums[1] > 0. ? std::sqrt(sums[0] / sums[1] * 4. / std::sqrt(3.)) : 0.;
}

/// |n_x| of the unit normal n along `gradient`.
double sideways_part(const Tensor<1, 3>& gradient) {
  return std::abs(gradient[0]) / std::max(gradient.norm(), 1e-6);
}

/// The box that holds the nodes on the chest wall.
std::pair<Point<3>, Point<3>> chest_box(const Body& body) {
  const std::vector<bool> on_chest = nodes_on_boundary(body, {chest_wall});
  Point<3> low, high;
  for (unsigned d = 0; d < 3; ++d) {
    double least = std::numeric_limits<double>::max(), most = -least;
    for (unsigned node = 0; node < on_chest.size(); ++node)
      if (on_chest[node]) {
        least = std::min(least, node_value(body.vertex_positions(), node)[d]);
        most = std::max(most, node_value(body.vertex_positions(), node)[d]);
      }
    low[d] = Utilities::MPI::min(least, body.communicator());
    high[d] = Utilities::MPI::max(most, body.communicator());
  }
  return {low, high};
}

} // namespace

const std::vector<std::string>& chest_condition_names() {
  static const std::vector<std::string> names{"fixed", "sliding", "one-sided"};
  return names;
}

SupportParameters::SupportParameters() : ParameterAcceptor("Supports") {}

void SupportParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Chest stiffness", chest_stiffness_,
                    "k, stiffness of the loose fascia between breast and chest wall: springs that "
                    "pull sliding tissue back to its unloaded position, f = -A k (x - X). Without "
                    "them a soft breast slides off sideways. Units: Pa/mm.",
                    Patterns::Double(0., 1e6));
  prm.add_parameter(
      "Lateral chest ratio", lateral_chest_ratio_,
      "rho, how much stiffer that fascia is where the chest faces sideways than where "
      "it faces forwards: k rho^|n_x|, n being the unit normal of the chest. A "
      "registration starts from it and finds what suits both images. Units: none.",
      Patterns::Double(1e-3, 1e3));
  prm.add_parameter("Chest smoothing", chest_smoothing_,
                    "Standard deviation of the Gaussian that smooths the distance from the chest, "
                    "over the cube root of the volume of a voxel. Units: none.",
                    Patterns::Double(0., 10.));
  prm.add_parameter(
      "Contact", contact_method_,
      "How sliding nodes are kept on the chest wall. projection: in every step positions are "
      "projected onto it, and velocities and forces onto its tangent plane. gradual: positions "
      "approach it with a limited speed, the paper's eqs. 10 and 11.",
      Patterns::Selection("projection|gradual"));
  prm.add_parameter("Correction part", gradual_.part,
                    "p of the paper's eq. 11: fraction of the distance to the chest wall that the "
                    "gradual contact corrects in a step. Units: none.",
                    Patterns::Double(0., 1.));
  prm.add_parameter("Speed limit", gradual_.speed_limit,
                    "v_max of the paper's eq. 11: the gradual contact corrects nodes that approach "
                    "the chest wall faster than this less. Units: mm/s.",
                    Patterns::Double(1e-3, 1e9));
  prm.add_parameter(
      "Cut planes", cut_planes_,
      "What holds tissue that is cut off by the border of the image. yielding: springs of the "
      "stiffness below, where the image in the other position shows tissue too; tissue that has "
      "bulged across the border is free. common: the same, but fixed. fixed: all of it is fixed. "
      "sliding: it moves in the plane, held by springs. elastic: springs on all of it. free: "
      "nothing.",
      Patterns::Selection("yielding|common|fixed|sliding|elastic|free"));
  prm.add_parameter(
      "Cut plane stiffness", cut_plane_stiffness_,
      "Stiffness of the springs that represent the tissue beyond a cut plane, between "
      "mu and its P-wave modulus over the width of that tissue. A registration "
      "starts from it and finds the stiffness that suits both images. Units: Pa/mm.",
      Patterns::Double(0., 1e6));
  prm.add_parameter("Contact stiffness", contact_stiffness,
                    "Penalty with which Newton's method keeps tissue on the chest wall: pressure "
                    "over distance from it. Units: Pa/mm.",
                    Patterns::Double(1., 1e12));
}

std::unique_ptr<Supports> SupportParameters::make(ChestCondition chest, const Body& body,
                                                  const image::LabelImage& labels,
                                                  const image::LabelImage& other,
                                                  unsigned chest_label, BaseFaces* faces) const {
  auto supports = std::make_unique<Supports>(body);
  add_cut_planes(labels.grid, other, *supports);
  add_chest(chest, labels, chest_label, *supports, faces);
  return supports;
}

void SupportParameters::add_chest(ChestCondition chest, const image::LabelImage& labels,
                                  unsigned chest_label, Supports& supports,
                                  BaseFaces* faces) const {
  if (chest == ChestCondition::fixed) {
    supports.fix({chest_wall});
    return;
  }
  const Body& body = supports.body();
  const auto [low, high] = chest_box(body);
  const double sigma = std::max(chest_smoothing_ * std::cbrt(labels.grid.voxel_volume()),
                                smoothing_in_edges * mean_edge(body, {chest_wall}));
  const auto surface =
      std::make_shared<ChestSurface>(labels, chest_label, sigma, low, high, farthest_slide);
  unsigned n_faces[2] = {0, 0}; // all, held
  supports.fix({chest_wall}, [&](const Tensor<1, 3>& centre, const Tensor<1, 3>& normal) {
    const bool is_held = std::abs(surface->gradient(centre) * normal) < least_slope;
    ++n_faces[0];
    n_faces[1] += is_held;
    return is_held;
  });
  Utilities::MPI::sum(ArrayView<const unsigned>(n_faces, 2), body.communicator(),
                      ArrayView<unsigned>(n_faces, 2));
  if (faces != nullptr)
    *faces = {n_faces[0], n_faces[1]};
  supports.slide_on(surface, {chest_wall},
                    chest == ChestCondition::sliding ? ContactLaw::tied : ContactLaw::one_sided);
  supports.contacts().set_method(
      contact_method_ == "gradual" ? ContactMethod::gradual : ContactMethod::projection, gradual_);
  if (chest_stiffness_ > 0.) {
    supports.add_springs({chest_wall}, chest_stiffness_);
    supports.grade_springs_on(chest_wall, [&](const Tensor<1, 3>& centre, const Tensor<1, 3>&) {
      return sideways_part(surface->gradient(centre));
    });
  }
}

void SupportParameters::add_cut_planes(const image::VoxelGrid& grid, const image::LabelImage& other,
                                       Supports& supports) const {
  if (cut_planes_ == "fixed")
    supports.fix({cut_plane});
  const FaceFilter held =
      need_other_labels() && !other.values.empty() ? held_beyond(other) : nullptr;
  if (cut_planes_ == "common")
    supports.fix({cut_plane}, held);
  if (cut_planes_ == "sliding")
    for (unsigned d = 0; d < 3; ++d) {
      Tensor<1, 3> axis;
      for (unsigned c = 0; c < 3; ++c)
        axis[c] = grid.direction[c][d];
      supports.slide_on(std::make_shared<mechanics::ParallelPlanes>(axis), {cut_plane},
                        ContactLaw::tied, least_alignment);
    }
  if (cut_plane_stiffness() > 0.)
    supports.add_springs({cut_plane}, cut_plane_stiffness_, held);
}

} // namespace prosup::unloading
