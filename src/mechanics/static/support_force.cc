#include "prosup/mechanics/static/support_force.h"

#include <vector>

namespace prosup::mechanics {

using namespace dealii;

namespace {

/// Penalty and springs, as nodal forces.
class SupportForce : public NodalForce {
public:
  SupportForce(const Supports& supports, double contact_stiffness)
      : supports_(supports), penalties_(supports.body().n_local_nodes()) {
    const Body& body = supports.body();
    const ContactSurfaces& contacts = supports.contacts();
    std::vector<std::vector<double>> areas;
    for (const auto& contact : contacts.surfaces())
      areas.push_back(lumped_area(body, contact.ids, body.vertex_positions()));
    for (const auto& c : contacts.nodes())
      penalties_[c.node].push_back(
          {&contacts.surfaces()[c.contact], contact_stiffness * areas[c.contact][c.node]});
  }

  bool evaluate(unsigned node, const Tensor<1, 3>& X, const Tensor<1, 3>& x, Tensor<1, 3>& force,
                Tensor<2, 3>& by_x, Tensor<2, 3>& by_X) const override {
    const auto& springs = supports_.spring_stiffness();
    const double spring = springs.empty() ? 0. : springs[node];
    if (!(spring > 0.) && penalties_[node].empty())
      return false;
    force = -spring * (x - X);
    by_x = -spring * unit_symmetric_tensor<3>();
    by_X = -by_x;
    for (const Penalty& penalty : penalties_[node])
      penalty.add(X, x, force, by_x, by_X);
    return true;
  }

private:
  struct Penalty {
    const ContactSurfaces::Contact* contact;
    double stiffness; ///< g/s^2

    /// f = -k (d(x) - d(X)) n(x).
    void add(const Tensor<1, 3>& X, const Tensor<1, 3>& x, Tensor<1, 3>& force, Tensor<2, 3>& by_x,
             Tensor<2, 3>& by_X) const {
      Tensor<1, 3> n, n_before;
      const Surface& surface = *contact->surface;
      const double gap = surface.distance(x, n) - surface.distance(X, n_before);
      if (contact->law == ContactLaw::one_sided && gap > 0.)
        return;
      force -= stiffness * gap * n;
      by_x -= stiffness * (outer_product(n, n) + gap * surface.curvature(x));
      by_X += stiffness * outer_product(n, n_before);
    }
  };

  const Supports& supports_;
  std::vector<std::vector<Penalty>> penalties_; // of each local node
};

} // namespace

std::unique_ptr<NodalForce> support_force(const Supports& supports, double contact_stiffness) {
  return std::make_unique<SupportForce>(supports, contact_stiffness);
}

} // namespace prosup::mechanics
