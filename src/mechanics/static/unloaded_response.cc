#include "prosup/mechanics/static/unloaded_response.h"

#include <algorithm>
#include <array>
#include <vector>

#include "dense_block.h"
#include "petsc_linear_algebra.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

using petsc::check;
using petsc::OwnedMatrix;
using petsc::OwnedVector;

/// For each local node, what is left of its three equations of balance, and what takes the place
/// of the others: t F + c dX = 0.
struct NodeEquations {
  explicit NodeEquations(const Body& body)
      : balance(body.n_local_nodes(), Tensor<2, 3>(unit_symmetric_tensor<3>())),
        constraint(body.n_local_nodes()) {}

  std::vector<Tensor<2, 3>> balance;    ///< t = I - sum w w^T, with the normals w at x
  std::vector<Tensor<2, 3>> constraint; ///< c = sum w W^T, with the normals W at X
};

/// A copy with ghosts.
NodeVector with_ghosts(const NodeVector& field) {
  NodeVector copy = field;
  copy.update_ghost_values();
  return copy;
}

NodeEquations equations_of(const Supports& supports, const NodeVector& unloaded) {
  NodeEquations equations(supports.body());
  ContactSurfaces contacts = supports.contacts();
  NodeVector X = with_ghosts(unloaded), u = supports.body().vertex_positions();
  contacts.put_on_surfaces(X);
  std::vector<Tensor<1, 3>> at_unloaded;
  for (const auto& contact : contacts.nodes())
    at_unloaded.push_back(contact.way_back);
  u -= X;
  u.update_ghost_values();
  contacts.linearize(X, u);
  for (std::size_t i = 0; i < at_unloaded.size(); ++i) {
    const auto& contact = contacts.nodes()[i];
    equations.balance[contact.node] -= outer_product(contact.way_back, contact.way_back);
    equations.constraint[contact.node] += outer_product(contact.way_back, at_unloaded[i]);
  }
  return equations;
}

/// The springs of a body alone.
class SpringForce : public NodalForce {
public:
  explicit SpringForce(const std::vector<double>& stiffness) : stiffness_(stiffness) {}

  bool evaluate(unsigned node, const Tensor<1, 3>& X, const Tensor<1, 3>& x, Tensor<1, 3>& force,
                Tensor<2, 3>& by_x, Tensor<2, 3>& by_X) const override {
    if (stiffness_.empty() || !(stiffness_[node] > 0.))
      return false;
    force = -stiffness_[node] * (x - X);
    by_x = -stiffness_[node] * Tensor<2, 3>(unit_symmetric_tensor<3>());
    by_X = -by_x;
    return true;
  }

private:
  const std::vector<double>& stiffness_;
};

/// Derivative of the area of a triangle by its corners.
std::array<Tensor<1, 3>, 3> area_by_corners(const std::array<Tensor<1, 3>, 3>& X) {
  Tensor<1, 3> normal = cross_product_3d(X[1] - X[0], X[2] - X[0]);
  normal /= normal.norm();
  std::array<Tensor<1, 3>, 3> result;
  for (unsigned a = 0; a < 3; ++a)
    result[a] = 0.5 * cross_product_3d(normal, X[(a + 2) % 3] - X[(a + 1) % 3]);
  return result;
}

/// A matrix with one row for each node and `n_entries` entries in each owned one.
OwnedMatrix make_node_matrix(const Body& body, const std::vector<PetscInt>& n_entries) {
  Mat matrix = nullptr;
  const auto n = static_cast<PetscInt>(body.n_owned_nodes()),
             n_all = static_cast<PetscInt>(n_global_nodes(body));
  const auto at_most = [&](PetscInt limit) {
    std::vector<PetscInt> result;
    for (const PetscInt n_row : n_entries)
      result.push_back(std::min(n_row, limit));
    return result;
  };
  const std::vector<PetscInt> own = at_most(3 * n), others = at_most(3 * (n_all - n));
  check(MatCreate(body.communicator(), &matrix));
  OwnedMatrix owned(matrix);
  check(MatSetSizes(matrix, n, 3 * n, PETSC_DETERMINE, PETSC_DETERMINE));
  check(MatSetType(matrix, MATAIJ));
  check(MatSeqAIJSetPreallocation(matrix, 0, own.data()));
  check(MatMPIAIJSetPreallocation(matrix, 0, own.data(), 0, others.data()));
  return owned;
}

void finish(const OwnedMatrix& matrix) {
  check(MatAssemblyBegin(matrix.get(), MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(matrix.get(), MAT_FINAL_ASSEMBLY));
}

} // namespace

/// -dF/dX = S + t V^T Q: S couples neighbours, the rows of V and Q are dv_a/dx and dp_a/dX of
/// averaged pressures (NodalPressure::Patch).
struct UnloadedResponse::Implementation {
  Implementation(const Supports& supports, const Material& material, const Tensor<1, 3>& body_force,
                 const NodeVector& unloaded)
      : supports_(supports), body_(supports.body()), equations_(equations_of(supports, unloaded)),
        springs_(supports.spring_stiffness()), unloaded_(with_ghosts(unloaded)),
        loaded_(with_ghosts(body_.vertex_positions())) {
    petsc::start();
    const petsc::QuietErrors quiet;
    NodeVector no_force;
    body_.initialize(no_force);
    Equilibrium balance(body_);
    balance.set_material(material);
    balance.set_fixed_nodes(supports.fixed());
    balance.set_nodal_force(&springs_);
    balance.set_external_force(body_force, no_force);
    balance.set_problem(Unknown::unloaded, loaded_);
    solution_ = petsc::make_vector(body_);
    right_side_ = petsc::make_vector(body_);
    forces_ = petsc::make_vector(body_);
    sparse_ = petsc::make_sparse_matrix(balance);
    std::vector<Product> products;
    assemble(sparse_, balance, products);
    set_products(products);
    if (averages_) {
      balance.take_local_pressure();
      const OwnedMatrix local = petsc::make_sparse_matrix(balance);
      assemble(local, balance, products);
      create_solver(local);
    } else {
      create_solver(sparse_);
    }
  }

  NodeVector to(const NodeVector& force, double tolerance) const {
    const petsc::QuietErrors quiet;
    set_right_side(force);
    check(KSPSetTolerances(solver_.get(), tolerance, 1e-50, 1e10, max_linear_iterations));
    check(KSPSolve(solver_.get(), right_side_.get(), solution_.get()));
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    check(KSPGetConvergedReason(solver_.get(), &reason));
    if (reason < 0)
      throw Error(format("GMRES did not find in %u iterations how the unloaded shape follows.",
                         max_linear_iterations));
    NodeVector result;
    body_.initialize(result);
    const PetscScalar* found = nullptr;
    check(VecGetArrayRead(solution_.get(), &found));
    std::copy_n(found, 3 * body_.n_owned_nodes(), result.begin());
    check(VecRestoreArrayRead(solution_.get(), &found));
    result.update_ghost_values();
    return result;
  }

  double imbalance(const NodeVector& force) const {
    const petsc::QuietErrors quiet;
    set_right_side(force);
    PetscReal norm = 0.;
    check(VecNorm(right_side_.get(), NORM_2, &norm));
    return norm;
  }

private:
  void set_right_side(const NodeVector& force) const {
    PetscScalar* values = nullptr;
    check(VecGetArray(right_side_.get(), &values));
    std::copy_n(force.begin(), 3 * body_.n_owned_nodes(), values);
    project_to_balance(values);
    for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
      if (supports_.fixed()[node])
        std::fill_n(values + 3 * node, 3, 0.);
    check(VecRestoreArray(right_side_.get(), &values));
  }

  struct Product {
    std::vector<int> nodes;
    std::vector<Tensor<1, 3>> u, w;
  };

  void assemble(const OwnedMatrix& matrix, const Equilibrium& balance,
                std::vector<Product>& products) {
    balance.tangent(
        unloaded_, [&](const auto& nodes, const auto& values) { add(matrix, nodes, values); },
        [&](const auto& nodes, const auto& u, const auto& w) {
          products.push_back({nodes, u, w});
        });
    add_spring_areas(matrix);
    const double scale = mean_diagonal(matrix);
    for (unsigned node = 0; node < body_.n_owned_nodes(); ++node) {
      const PetscInt row = global(node);
      const Tensor<2, 3> block = scale * equations_.constraint[node];
      if (block.norm() > 0.)
        check(MatSetValuesBlocked(matrix.get(), 1, &row, 1, &row, dense(block).data(), ADD_VALUES));
    }
    finish(matrix);
  }

  /// Assembles the matrix for the time being.
  double mean_diagonal(const OwnedMatrix& matrix) const {
    finish(matrix);
    check(MatGetDiagonal(matrix.get(), solution_.get()));
    PetscScalar sum = 0.;
    PetscInt n = 1;
    check(VecSum(solution_.get(), &sum));
    check(VecGetSize(solution_.get(), &n));
    return sum / static_cast<double>(n);
  }

  void set_products(const std::vector<Product>& products) {
    averages_ = Utilities::MPI::max(static_cast<int>(products.size()), body_.communicator()) > 0;
    if (!averages_)
      return;
    std::vector<PetscInt> n_entries;
    for (const Product& product : products)
      n_entries.push_back(static_cast<PetscInt>(3 * product.nodes.size()));
    volumes_ = make_node_matrix(body_, n_entries);
    pressures_ = make_node_matrix(body_, n_entries);
    PetscInt row = 0;
    check(MatGetOwnershipRange(volumes_.get(), &row, nullptr));
    std::vector<PetscInt> columns;
    std::vector<double> u, w;
    for (const Product& product : products) {
      columns.clear(), u.clear(), w.clear();
      for (std::size_t a = 0; a < product.nodes.size(); ++a) {
        for (unsigned c = 0; c < 3; ++c) {
          columns.push_back(3 * product.nodes[a] + static_cast<int>(c));
          u.push_back(product.u[a][c]);
          w.push_back(product.w[a][c]);
        }
      }
      const auto n = static_cast<PetscInt>(columns.size());
      check(MatSetValues(volumes_.get(), 1, &row, n, columns.data(), u.data(), INSERT_VALUES));
      check(MatSetValues(pressures_.get(), 1, &row, n, columns.data(), w.data(), INSERT_VALUES));
      ++row;
    }
    finish(volumes_);
    finish(pressures_);
    Vec at_nodes = nullptr;
    check(MatCreateVecs(pressures_.get(), nullptr, &at_nodes));
    at_nodes_.reset(at_nodes);
  }

  int global(unsigned node) const {
    return static_cast<int>(body_.vertex_positions().get_partitioner()->local_to_global(3 * node) /
                            3);
  }
  unsigned local(int node) const {
    return body_.vertex_positions().get_partitioner()->global_to_local(
               static_cast<types::global_dof_index>(3) * node) /
           3;
  }

  /// Adds blocks, of which each row is projected to what is left of the balance of its node.
  void add(const OwnedMatrix& matrix, const std::vector<int>& nodes,
           const std::vector<double>& values) {
    const std::size_t n = 3 * nodes.size();
    projected_.resize(n * n);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const Tensor<2, 3>& t = equations_.balance[local(nodes[a])];
      const double* rows = values.data() + 3 * a * n;
      for (unsigned i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < n; ++j)
          projected_[(3 * a + i) * n + j] =
              t[i][0] * rows[j] + t[i][1] * rows[n + j] + t[i][2] * rows[2 * n + j];
    }
    const auto size = static_cast<PetscInt>(nodes.size());
    check(MatSetValuesBlocked(matrix.get(), size, nodes.data(), size, nodes.data(),
                              projected_.data(), ADD_VALUES));
  }

  /// The springs of a face act on its unloaded area: k w_a (x_a - X_a) (dA/dX_b)^T.
  void add_spring_areas(const OwnedMatrix& matrix) {
    std::vector<double> values;
    std::vector<int> nodes;
    for (const auto& spring : supports_.spring_faces()) {
      const auto& face = body_.boundary_faces()[spring.face].nodes;
      const auto area =
          area_by_corners({node_value(unloaded_, face[0]), node_value(unloaded_, face[1]),
                           node_value(unloaded_, face[2])});
      nodes.clear();
      for (const unsigned node : face)
        nodes.push_back(global(node));
      const std::size_t n = 3 * face.size();
      values.assign(n * n, 0.);
      for (std::size_t a = 0; a < face.size(); ++a) {
        const Tensor<1, 3> u = spring.stiffness * area_part(face.size(), a) *
                               (node_value(loaded_, face[a]) - node_value(unloaded_, face[a]));
        for (unsigned b = 0; b < 3; ++b)
          if (!supports_.fixed()[face[a]] && !supports_.fixed()[face[b]])
            for (unsigned i = 0; i < 3; ++i)
              for (unsigned j = 0; j < 3; ++j)
                values[(3 * a + i) * n + 3 * b + j] = u[i] * area[b][j];
      }
      add(matrix, nodes, values);
    }
  }

  static PetscErrorCode multiply(Mat shell, Vec x, Vec y) {
    void* context = nullptr;
    PetscCall(MatShellGetContext(shell, &context));
    const auto& self = *static_cast<const Implementation*>(context);
    PetscCall(MatMult(self.sparse_.get(), x, y));
    PetscCall(MatMult(self.pressures_.get(), x, self.at_nodes_.get()));
    PetscCall(MatMultTranspose(self.volumes_.get(), self.at_nodes_.get(), self.forces_.get()));
    PetscScalar* forces = nullptr;
    PetscCall(VecGetArray(self.forces_.get(), &forces));
    self.project_to_balance(forces);
    PetscCall(VecRestoreArray(self.forces_.get(), &forces));
    return VecAXPY(y, 1., self.forces_.get());
  }

  /// Leaves of forces at owned nodes what counts in their equations of balance.
  void project_to_balance(double* forces) const {
    for (unsigned node = 0; node < body_.n_owned_nodes(); ++node, forces += 3) {
      const Tensor<1, 3> f =
          equations_.balance[node] * Tensor<1, 3>({forces[0], forces[1], forces[2]});
      std::copy_n(f.begin_raw(), 3, forces);
    }
  }

  /// With a matrix that couples neighbours only for multigrid.
  void create_solver(const OwnedMatrix& local) {
    KSP solver = nullptr;
    check(KSPCreate(body_.communicator(), &solver));
    solver_.reset(solver);
    if (averages_) {
      Mat shell = nullptr;
      const auto n = static_cast<PetscInt>(3 * body_.n_owned_nodes());
      check(MatCreateShell(body_.communicator(), n, n, PETSC_DETERMINE, PETSC_DETERMINE, this,
                           &shell));
      whole_.reset(shell);
      check(MatShellSetOperation(shell, MATOP_MULT,
                                 reinterpret_cast<void (*)()>(&Implementation::multiply)));
    }
    Mat multigrid = nullptr;
    check(MatConvert(local.get(), MATAIJ, MAT_INITIAL_MATRIX, &multigrid));
    multigrid_.reset(multigrid);
    check(MatSetBlockSize(multigrid, 3));
    check(KSPSetOperators(solver, averages_ ? whole_.get() : sparse_.get(), multigrid));
    petsc::set_gauss_seidel_multigrid(solver);
    check(KSPSetUp(solver));
  }

  const Supports& supports_;
  const Body& body_;
  const NodeEquations equations_;
  const SpringForce springs_;
  const NodeVector unloaded_, loaded_; // X, x
  std::vector<double> projected_;
  bool averages_ = false;
  OwnedMatrix sparse_, volumes_, pressures_; // S, V, Q
  OwnedMatrix multigrid_;                    // like the whole, but couples neighbours only
  OwnedMatrix whole_;                        // S + t V^T Q
  OwnedVector solution_, right_side_, at_nodes_, forces_;
  petsc::Owned<KSP, KSPDestroy> solver_;
};

bool UnloadedResponse::applies_to(const Supports& supports) {
  return supports.contacts().ties_exactly();
}

UnloadedResponse::UnloadedResponse(const Supports& supports, const Material& material,
                                   const Tensor<1, 3>& body_force, const NodeVector& unloaded)
    : implementation_(std::make_unique<Implementation>(supports, material, body_force, unloaded)) {}

UnloadedResponse::~UnloadedResponse() = default;

NodeVector UnloadedResponse::to(const NodeVector& force, double tolerance) const {
  return implementation_->to(force, tolerance);
}

double UnloadedResponse::imbalance(const NodeVector& force) const {
  return implementation_->imbalance(force);
}

} // namespace prosup::mechanics
