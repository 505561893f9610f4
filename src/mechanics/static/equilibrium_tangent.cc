#include <deal.II/lac/sparsity_tools.h>

#include <memory>
#include <variant>

#include "dense_block.h"
#include "equilibrium.h"
#include "mechanics/element/membrane.h"
#include "mechanics/element/nodal_pressure.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

/// sum over components of u_i w_j as a dense block.
void outer(const std::vector<Tensor<1, 3>>& u, const std::vector<Tensor<1, 3>>& w,
           std::vector<double>& values) {
  values.clear();
  for (const Tensor<1, 3>& row : u)
    for (unsigned i = 0; i < 3; ++i)
      for (const Tensor<1, 3>& column : w)
        for (unsigned j = 0; j < 3; ++j)
          values.push_back(row[i] * column[j]);
}

} // namespace

void Equilibrium::tangent(const NodeVector& unknown, const AddBlock& add) const {
  std::vector<double> values;
  tangent(unknown, add, [&](const auto& nodes, const auto& u, const auto& w) {
    outer(u, w, values);
    add(nodes, values);
  });
}

void Equilibrium::tangent(const NodeVector& unknown, const AddBlock& add,
                          const AddProduct& add_product) const {
  std::unique_ptr<NodalPressure> pressure;
  if (averages_pressure()) {
    pressure = std::make_unique<NodalPressure>(body_);
    pressure->evaluate(material_, unloaded(unknown), loaded(unknown));
    for (const auto& patch : pressure->patches(unknown_ == Unknown::loaded, fixed_))
      add_product(patch.nodes, patch.volume_change, patch.pressure_change);
  }
  std::visit([&](const auto& law) { add_element_tangents(law, unknown, pressure.get(), add); },
             material_.law());
  add_skin_tangents(unknown, add);
  add_nodal_tangents(unknown, add);
}

void Equilibrium::add_skin_tangents(const NodeVector& unknown, const AddBlock& add) const {
  ElementMatrix matrix;
  std::vector<int> global(3);
  for (const auto& triangle : skin_) {
    const MembraneTriangle membrane(corners_of(triangle, unloaded(unknown)),
                                    corners_of(triangle, loaded(unknown)),
                                    material_.skin().stiffness);
    const auto blocks = unknown_ == Unknown::loaded ? membrane.by_loaded() : membrane.by_unloaded();
    matrix.reset(3);
    for (unsigned a = 0; a < 3; ++a)
      for (unsigned b = 0; b < 3; ++b)
        matrix.add(a, b, blocks[3 * a + b]);
    for (unsigned a = 0; a < 3; ++a) {
      global[a] = global_node(triangle[a]);
      if (fixed_[triangle[a]])
        matrix.clear(a);
    }
    add(global, matrix.values);
  }
}

template <typename L>
void Equilibrium::add_element_tangents(const L& law, const NodeVector& unknown,
                                       const NodalPressure* pressure, const AddBlock& add) const {
  const unsigned n = shape_.n_nodes;
  ElementMatrix matrix;
  std::vector<int> global(n);
  for (unsigned e = 0; e < body_.n_elements(); ++e) {
    const ElementVector X = element_positions(body_, e, unloaded(unknown)),
                        x = element_positions(body_, e, loaded(unknown));
    const double p = pressure != nullptr ? pressure->element_pressure(e) : 0.;
    matrix.reset(n);
    for (unsigned q = 0; q < shape_.n_points; ++q) {
      const PointKinematics point = point_kinematics(shape_, q, X, x);
      const PointResponse response = point_response(law, e, point);
      if (unknown_ == Unknown::loaded) {
        add_tangent_by_loaded(point, response, p, matrix);
        continue;
      }
      add_tangent_by_unloaded(point, response, matrix);
      add_body_force_by_unloaded(point, body_force_, -load_fraction_, matrix);
    }
    for (unsigned a = 0; a < n; ++a) {
      const unsigned node = body_.element_nodes(e)[a];
      global[a] = global_node(node);
      if (fixed_[node])
        matrix.clear(a);
    }
    add(global, matrix.values);
  }
}

void Equilibrium::add_nodal_tangents(const NodeVector& unknown, const AddBlock& add) const {
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node) {
    Tensor<1, 3> force;
    Tensor<2, 3> by_x, by_X;
    if (fixed_[node])
      add({global_node(node)}, dense(unit_symmetric_tensor<3>()));
    else if (nodal_force_ != nullptr &&
             nodal_force_->evaluate(node, node_value(unloaded(unknown), node),
                                    node_value(loaded(unknown), node), force, by_x, by_X))
      add({global_node(node)}, dense(unknown_ == Unknown::loaded ? -by_x : -by_X));
  }
}

DynamicSparsityPattern Equilibrium::node_pattern(bool with_products) const {
  const unsigned n_nodes = n_global_nodes(body_);
  const IndexSet all_rows = complete_index_set(n_nodes);
  DynamicSparsityPattern pattern(n_nodes, n_nodes, all_rows);
  const auto couple = [&](const auto& nodes) {
    for (const auto row : nodes)
      for (const auto column : nodes)
        pattern.add(row, column);
  };
  std::vector<int> global(shape_.n_nodes);
  for (unsigned e = 0; e < body_.n_elements(); ++e) {
    for (unsigned a = 0; a < shape_.n_nodes; ++a)
      global[a] = global_node(body_.element_nodes(e)[a]);
    couple(global);
  }
  if (with_products && averages_pressure()) {
    NodalPressure pressure(body_);
    const Material any(LameParameters{1., 1.});
    pressure.evaluate(any, body_.vertex_positions(), body_.vertex_positions());
    for (const auto& patch : pressure.patches(true, fixed_))
      couple(patch.nodes);
  }
  IndexSet owned(n_nodes);
  if (body_.n_owned_nodes() > 0)
    owned.add_range(global_node(0), global_node(0) + body_.n_owned_nodes());
  SparsityTools::distribute_sparsity_pattern(pattern, owned, body_.communicator(), all_rows);
  return pattern;
}

} // namespace prosup::mechanics
