#include "element_batches.h"

#include <deal.II/base/aligned_vector.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <variant>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "element_kernel.h"
#include "prosup/core/error.h"
#include "prosup/core/tet_topology.h"

namespace prosup::mechanics {

using namespace dealii;
using kernel::n_lanes;

namespace {

/// Flushes denormal numbers to zero in this scope: forces that fade away
/// would make single precision several times slower.
class FlushDenormals {
public:
#if defined(__SSE__)
  FlushDenormals() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | 0x8040);
  }
  ~FlushDenormals() {
    _mm_setcsr(before_);
  }

private:
  unsigned before_;
#endif
};

template <typename Real>
const kernel::Kernels<Real>& kernels_named(const std::string& instruction_set) {
  int n = 0;
  const auto* all = kernel::all_kernels<Real>(n);
  std::string names;
  for (int i = 0; i < n; ++i) {
    if (instruction_set == all[i]->instruction_set)
      return *all[i];
    names += std::string(", ") + all[i]->instruction_set;
  }
  if (instruction_set != "best")
    throw Error("This processor does not have the instruction set '" + instruction_set +
                "' of 'Elements/Instruction set'; it can run best" + names + ".");
  return *all[n - 1]; // the last is the best
}

/// Number of elements with nodes of other ranks; they come first.
unsigned n_interface_elements(const Body& body) {
  const auto is_interior = [&](unsigned element) {
    const unsigned* nodes = body.element_nodes(element);
    return std::all_of(nodes, nodes + body.element().n_nodes(),
                       [&](unsigned node) { return node < body.n_owned_nodes(); });
  };
  unsigned n = 0;
  while (n < body.n_elements() && !is_interior(n))
    ++n;
  return n;
}

template <typename Real, typename Batch>
class Batches : public ElementBatches {
public:
  explicit Batches(const Body& body)
      : body_(body), is_averaged_(body.element().type == ElementType::nodal_pressure),
        kernels_(kernels_named<Real>(body.element().instruction_set)) {
    const unsigned n_interface = n_interface_elements(body);
    const unsigned half = (n_interface + body.n_elements()) / 2;
    add_part(interface, 0, n_interface);
    add_part(first_interior, n_interface, half);
    add_part(second_interior, half, body.n_elements());
  }

  void set_material(const Material& material) override {
    law_ = material.law();
    stride_ = material.is_uniform() ? 0 : 1;
    materials_.resize(material.is_uniform() ? 1 : batches_.size());
    for (std::size_t i = 0; i < materials_.size(); ++i)
      for (unsigned lane = 0; lane < n_lanes; ++lane) {
        const LameParameters& parameters =
            material[material.is_uniform() ? 0 : element_of_[n_lanes * i + lane]];
        materials_[i].mu[lane] = static_cast<Real>(parameters.mu);
        materials_[i].lambda[lane] = static_cast<Real>(parameters.lambda);
      }
  }

  double set_reference(const double* positions) override {
    if constexpr (is_quadratic)
      return kernels_.set_quadratic_reference(batches_.data(), 0, batches_.size(), positions);
    else
      return kernels_.set_linear_reference(batches_.data(), 0, batches_.size(), positions);
  }

  double add_forces(Part part, const double* positions, double* force) const override {
    if constexpr (std::is_same_v<Real, float>) {
      const FlushDenormals scope;
      return add(part, positions, force);
    } else {
      return add(part, positions, force);
    }
  }

  void add_nodal_volumes(Part part, const double* positions, double* volumes) const override {
    if constexpr (!is_quadratic)
      kernels_.add_nodal_volumes(batches_.data(), begin_[part], begin_[part + 1], positions,
                                 volumes);
  }

private:
  static constexpr bool is_quadratic = std::is_same_v<Batch, kernel::QuadraticBatch<Real>>;

  void add_part(Part part, unsigned first, unsigned last) {
    constexpr unsigned n_nodes = sizeof(Batch::node) / sizeof(Batch::node[0]);
    begin_[part] = batches_.size();
    batches_.resize(begin_[part] + (last - first + n_lanes - 1) / n_lanes);
    begin_[part + 1] = batches_.size();
    for (std::size_t i = n_lanes * begin_[part]; i < n_lanes * begin_[part + 1]; ++i) {
      const unsigned element = first++;
      const bool is_padding = element >= last;
      element_of_.push_back(is_padding ? last - 1 : element);
      for (unsigned a = 0; a < n_nodes; ++a)
        batches_[i / n_lanes].node[a][i % n_lanes] =
            is_padding ? body_.n_local_nodes() + a : body_.element_nodes(element)[a];
    }
  }

  double add(Part part, const double* positions, double* force) const {
    const kernel::Materials<Real> materials{materials_.data(), stride_};
    const auto run = [&](const auto& law) {
      const auto& kernels = kernels_.of(law);
      const auto with = [&](auto kernel) {
        return kernel(law, batches_.data(), begin_[part], begin_[part + 1], materials, positions,
                      force);
      };
      if constexpr (is_quadratic)
        return with(kernels.add_quadratic);
      else
        return with(is_averaged_ ? kernels.add_nodal_pressure : kernels.add_linear);
    };
    return std::visit(run, law_);
  }

  const Body& body_;
  const bool is_averaged_;
  const kernel::Kernels<Real>& kernels_;
  Law law_;
  AlignedVector<Batch> batches_;
  AlignedVector<kernel::BatchMaterial<Real>> materials_;
  std::size_t stride_ = 0;
  std::array<std::size_t, n_parts + 1> begin_{};
  std::vector<unsigned> element_of_; // of each lane
};

template <typename Real>
std::unique_ptr<ElementBatches> create_batches(const Body& body) {
  if (body.element().degree() == 2)
    return std::make_unique<Batches<Real, kernel::QuadraticBatch<Real>>>(body);
  return std::make_unique<Batches<Real, kernel::LinearBatch<Real>>>(body);
}

} // namespace

std::unique_ptr<ElementBatches> ElementBatches::create(const Body& body) {
  return body.element().precision == Precision::double_precision ? create_batches<double>(body)
                                                                 : create_batches<float>(body);
}

void place_padding_nodes(double* behind_the_nodes) {
  constexpr double corners[4][3] = {{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}};
  const auto place = [&](unsigned node, unsigned a, unsigned b) {
    for (unsigned c = 0; c < 3; ++c)
      behind_the_nodes[kernel::node_stride * node + c] = 0.5 * (corners[a][c] + corners[b][c]);
  };
  for (unsigned a = 0; a < 4; ++a)
    place(a, a, a);
  for (unsigned e = 0; e < 6; ++e)
    place(4 + e, tet_edges[e][0], tet_edges[e][1]);
}

} // namespace prosup::mechanics
