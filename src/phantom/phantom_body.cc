#include "prosup/phantom/phantom_body.h"

#include <cmath>
#include <memory>

#include "prosup/core/collective.h"
#include "prosup/mechanics/static/support_force.h"
#include "prosup/mesh/deformation.h"
#include "prosup/mesh/distributed.h"
#include "prosup/mesh/mask_mesher.h"
#include "prosup/mesh/refine.h"
#include "prosup/phantom/chest_cylinder.h"
#include "prosup/phantom/grids.h"

namespace prosup::phantom {

using namespace dealii;
using mechanics::node_value;
using mechanics::NodeVector;

namespace {

constexpr double edges_per_voxel = 5.; // of the labels that the mesh is made of

constexpr auto chest_wall = mesh::boundary_id_of(mesh::BoundaryPart::chest_wall),
               cut_plane = mesh::boundary_id_of(mesh::BoundaryPart::cut_plane),
               skin = mesh::boundary_id_of(mesh::BoundaryPart::skin);

mesh::TetMesh make_mesh(double edge_length, const Anatomy& anatomy) {
  image::LabelImage labels(meshing_grid(anatomy.geometry(), edge_length / edges_per_voxel));
  const auto& size = labels.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i)
        labels(i, j, k) = anatomy.label(labels.grid.physical(double(i), double(j), double(k)));
  Labels meaning;
  meaning.chest = chest;
  meaning.tissues = {fat, gland};
  meaning.gland = gland;
  mesh::MaskMesher mesher(meaning);
  mesher.edge_length = edge_length;
  return mesher.mesh(labels);
}

void set_node(NodeVector& vector, unsigned node, const Tensor<1, 3>& value) {
  for (unsigned c = 0; c < 3; ++c)
    vector.local_element(3 * node + c) = value[c];
}

} // namespace

PhantomBody::PhantomBody(const MechanicsParameters& parameters, const Anatomy& anatomy,
                         MPI_Comm communicator)
    : parameters_(parameters), geometry_(anatomy.geometry()) {
  mesh::TetMesh mesh;
  on_root(communicator, [&] {
    mesh = make_mesh(parameters.edge_length, anatomy);
    mesh_ = mesh::refined(mesh);
  });
  body_ =
      std::make_unique<mechanics::Body>(*mesh::make_distributed(mesh, communicator),
                                        mechanics::Element{mechanics::ElementType::quadratic,
                                                           mechanics::Precision::double_precision});
  put_on_surfaces();
}

void PhantomBody::put_on_surfaces() {
  unloaded_ = body_->vertex_positions();
  unloaded_.update_ghost_values();
  const std::vector<bool> on_skin = nodes_on_boundary(*body_, {skin}),
                          on_chest = nodes_on_boundary(*body_, {chest_wall});
  for (unsigned node = 0; node < body_->n_local_nodes(); ++node) {
    const Point<3> X(node_value(unloaded_, node));
    if (on_chest[node])
      set_node(unloaded_, node, geometry_.on_chest(X));
    else if (on_skin[node])
      set_node(unloaded_, node, geometry_.on_skin(X));
  }
}

mechanics::Material PhantomBody::material() const {
  std::vector<mechanics::LameParameters> parameters;
  for (const unsigned tissue : body_->material_ids()) {
    const double ratio = tissue == gland ? parameters_.gland_ratio : 1.;
    parameters.push_back(mechanics::lame_parameters(ratio * parameters_.fat_shear_modulus,
                                                    parameters_.poisson_ratio));
  }
  mechanics::Material material(parameters);
  material.set_skin({skin, parameters_.skin_stiffness});
  return material;
}

NodeVector PhantomBody::push(double pressure) const {
  const Point<3> centre = geometry_.on_skin({geometry_.sigma, 0., 0.});
  const std::vector<double> area = lumped_area(*body_, mechanics::BoundaryIds{skin}, unloaded_);
  NodeVector force;
  body_->initialize(force);
  for (unsigned node = 0; node < body_->n_owned_nodes(); ++node) {
    const double distance = (node_value(unloaded_, node) - centre).norm() / parameters_.push_radius;
    force.local_element(3 * node) = -pressure * area[node] * std::exp(-0.5 * distance * distance);
  }
  return force;
}

LoadedPhantom PhantomBody::load(const Load& load, const mechanics::QuasiStaticParameters& solver,
                                const Log& log) const {
  mechanics::QuasiStatic quasi_static(solver, *body_, log);
  quasi_static.set_material(material());
  quasi_static.set_body_force(load.body_force);
  if (load.push_pressure != 0.)
    quasi_static.set_external_force(push(load.push_pressure));
  mechanics::Supports supports(*body_, {cut_plane});
  if (parameters_.chest_slides()) {
    supports.slide_on(std::make_shared<ChestCylinder>(geometry_), {chest_wall},
                      mechanics::ContactLaw::tied);
    supports.add_springs({chest_wall}, parameters_.fascia_stiffness);
  } else {
    supports.fix({chest_wall});
  }
  supports.set_reference(unloaded_);
  const auto support_force = mechanics::support_force(supports, parameters_.contact_stiffness);
  quasi_static.set_fixed_nodes(supports.fixed());
  quasi_static.set_nodal_force(support_force.get());

  NodeVector displacement;
  body_->initialize(displacement);
  displacement.update_ghost_values();
  LoadedPhantom loaded;
  loaded.result = quasi_static.load(unloaded_, displacement);
  loaded.mesh.mesh = mesh_;
  loaded.mesh.unloaded = mesh::at_nodes(mesh_, body_->gather_at_cells(unloaded_));
  displacement += unloaded_;
  displacement.update_ghost_values();
  loaded.mesh.mesh.points = mesh::at_nodes(mesh_, body_->gather_at_cells(displacement));
  return loaded;
}

} // namespace prosup::phantom
