#include "nodal_pressure.h"

#include <deal.II/base/mpi.h>

#include <cmath>
#include <map>
#include <variant>

namespace prosup::mechanics {

using namespace dealii;

namespace {

using Factors = std::pair<Tensor<1, 3>, Tensor<1, 3>>;
/// Of each node of a patch, by global number.
using Row = std::map<unsigned, Factors>;

constexpr unsigned n_packed = 8; // two global nodes and two vectors

void pack(unsigned of, const Row& row, std::vector<double>& message) {
  for (const auto& [node, factors] : row) {
    message.push_back(of);
    message.push_back(node);
    for (const Tensor<1, 3>& factor : {factors.first, factors.second})
      message.insert(message.end(), factor.begin_raw(), factor.end_raw());
  }
}

void add_to(Row& row, unsigned node, const Tensor<1, 3>& first, const Tensor<1, 3>& second) {
  Factors& factors = row[node];
  factors.first += first;
  factors.second += second;
}

/// Adds the rows of ghosts to those of their owners.
void send_ghost_rows(const Utilities::MPI::Partitioner& partitioner, std::vector<Row>& rows) {
  std::map<unsigned, std::vector<double>> messages;
  unsigned ghost = partitioner.locally_owned_size() / 3;
  for (const auto& [rank, n_components] : partitioner.ghost_targets())
    for (unsigned i = 0; i < n_components / 3; ++i, ++ghost)
      pack(partitioner.local_to_global(3 * ghost) / 3, rows[ghost], messages[rank]);
  const auto received = Utilities::MPI::some_to_some(partitioner.get_mpi_communicator(), messages);
  for (const auto& [rank, message] : received)
    for (std::size_t i = 0; i < message.size(); i += n_packed) {
      const double* entry = message.data() + i;
      const unsigned of = partitioner.global_to_local(3 * static_cast<unsigned>(entry[0])) / 3;
      add_to(rows[of], static_cast<unsigned>(entry[1]),
             Tensor<1, 3>({entry[2], entry[3], entry[4]}),
             Tensor<1, 3>({entry[5], entry[6], entry[7]}));
    }
}

} // namespace

ElementVector element_positions(const Body& body, unsigned element, const NodeVector& positions) {
  ElementVector values;
  for (unsigned a = 0; a < body.element().n_nodes(); ++a)
    values[a] = node_value(positions, body.element_nodes(element)[a]);
  return values;
}

NodalPressure::NodalPressure(const Body& body) : body_(body) {
  body.initialize(sums_);
}

void NodalPressure::evaluate(const Material& material, const NodeVector& unloaded,
                             const NodeVector& loaded) {
  material_ = &material;
  unloaded_ = &unloaded;
  loaded_ = &loaded;
  sums_ = 0.;
  for (unsigned e = 0; e < body_.n_elements(); ++e) {
    const PointKinematics point = point_kinematics(element_shape(ElementType::nodal_pressure), 0,
                                                   element_positions(body_, e, unloaded),
                                                   element_positions(body_, e, loaded));
    for (unsigned a = 0; a < 4; ++a) {
      double* sum = sums_.begin() + 3 * static_cast<std::size_t>(body_.element_nodes(e)[a]);
      sum[0] += 0.25 * point.volume;
      sum[1] += 0.25 * point.volume * point.jacobian;
      sum[2] += 0.25 * point.volume * material[e].lambda;
    }
  }
  sums_.compress(VectorOperation::add);
  sums_.update_ghost_values();
  std::visit([&](const auto& law) { evaluate_nodes(law); }, material.law());
}

template <typename L>
void NodalPressure::evaluate_nodes(const L& law) {
  nodes_.resize(body_.n_local_nodes());
  for (unsigned a = 0; a < nodes_.size(); ++a) {
    const Tensor<1, 3> sum = node_value(sums_, a);
    const double J = sum[1] / sum[0], lambda = sum[2] / sum[0], log_J = std::log(J);
    const double slope = law.volume_slope(lambda, log_J);
    nodes_[a] = {sum[0],
                 J,
                 lambda,
                 slope / J,
                 (law.volume_curvature(lambda, log_J) - slope) / (J * J),
                 law.volume_slope(1., log_J) / J};
  }
}

double NodalPressure::element_pressure(unsigned element) const {
  double pressure = 0.;
  for (unsigned a = 0; a < 4; ++a)
    pressure += 0.25 * nodes_[body_.element_nodes(element)[a]].pressure;
  return pressure;
}

double NodalPressure::pressure_by_volume(const Node& node, double element_lambda, bool by_loaded) {
  if (by_loaded)
    return node.by_jacobian / node.unloaded_volume;
  return ((element_lambda - node.lambda) * node.by_lambda - node.by_jacobian * node.jacobian) /
         node.unloaded_volume;
}

std::vector<NodalPressure::Patch> NodalPressure::patches(bool by_loaded,
                                                         const std::vector<bool>& fixed) const {
  const auto& partitioner = *sums_.get_partitioner();
  std::vector<Row> rows(body_.n_local_nodes());
  for (unsigned e = 0; e < body_.n_elements(); ++e) {
    const PointKinematics point = point_kinematics(element_shape(ElementType::nodal_pressure), 0,
                                                   element_positions(body_, e, *unloaded_),
                                                   element_positions(body_, e, *loaded_));
    const unsigned* nodes = body_.element_nodes(e);
    for (unsigned a = 0; a < 4; ++a) {
      const double factor = pressure_by_volume(nodes_[nodes[a]], (*material_)[e].lambda, by_loaded);
      for (unsigned b = 0; b < 4; ++b) {
        const double share = fixed[nodes[b]] ? 0. : 0.25 * point.volume;
        const Tensor<1, 3> loaded = share * point.jacobian * point.gradient_x[b];
        add_to(rows[nodes[a]], partitioner.local_to_global(3 * nodes[b]) / 3, loaded,
               factor * (by_loaded ? loaded : share * point.gradient_X[b]));
      }
    }
  }
  send_ghost_rows(partitioner, rows);
  std::vector<Patch> patches(body_.n_owned_nodes());
  for (unsigned a = 0; a < patches.size(); ++a)
    for (const auto& [node, factors] : rows[a]) {
      patches[a].nodes.push_back(static_cast<int>(node));
      patches[a].volume_change.push_back(factors.first);
      patches[a].pressure_change.push_back(factors.second);
    }
  return patches;
}

} // namespace prosup::mechanics
