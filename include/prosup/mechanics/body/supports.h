#ifndef PROSUP_MECHANICS_SUPPORTS_H
#define PROSUP_MECHANICS_SUPPORTS_H

#include <deal.II/base/types.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/body/nodal_force.h"
#include "prosup/mechanics/body/surface.h"

namespace prosup::mechanics {

/// How nodes are kept on a surface along which they may slide.
enum class ContactLaw {
  tied,     ///< they stay on it
  one_sided ///< they may lift off but not sink in
};

/// By which means.
enum class ContactMethod {
  projection, ///< position, velocity and force are projected to the tangent plane
  gradual     ///< the paper's eq. 10 and 11: small corrections with a limited speed
};

/// The paper's s(v) = p / (1 + exp(l (v - v_max))), l = 10 ln 9 / v_max (eq. 11).
/// A correction in every step acts like a spring of stiffness m p/h^2, so that
/// nodes hang off the surface by their load over it. The paper's p = 0.005 goes
/// with its short steps of a fine grid; steps here are more than ten times longer.
struct GradualCorrection {
  double part = 0.5;         ///< p, of the distance to the surface in a step
  double speed_limit = 500.; ///< v_max, mm/s
};

/// Everything that holds a body: boundaries that do not move, surfaces along
/// which nodes slide, each on the level set that it lies on in the loaded
/// configuration, and springs
///   f_a = -A_a k (x_a - X_a),
/// A_a being the area lumped to the node in the unloaded configuration and k in
/// Pa/mm. Nodes of both configurations lie on the surface. All functions are
/// collective on the communicator of the body unless said.
class Supports {
public:
  using BoundaryIds = std::set<dealii::types::boundary_id>;

  /// The nodes of the boundaries `fixed` do not move.
  explicit Supports(const Body& body, const BoundaryIds& fixed = {});

  /// The nodes of these boundaries do not move, or of those of their faces that
  /// pass the filter.
  void fix(const BoundaryIds& ids, const Body::FaceFilter& counts = {});
  /// The nodes of these boundaries slide. `least_alignment`: only faces whose
  /// normal makes an angle of at most this cosine with that of the surface count.
  void slide_on(std::shared_ptr<const Surface> surface, const BoundaryIds& ids, ContactLaw law,
                double least_alignment = 0.);

  /// Adds springs of `stiffness` (Pa/mm) to these boundaries.
  void add_springs(const BoundaryIds& ids, double stiffness);
  /// Changes the stiffness (Pa/mm) of all springs that stand on this boundary, from the
  /// next set_reference() on. Local.
  void set_springs_on(dealii::types::boundary_id id, double stiffness);

  /// `correction` is that of ContactMethod::gradual.
  void set_contact_method(ContactMethod method, const GradualCorrection& correction);

  const Body& body() const { return body_; }
  /// For each local node. Local.
  const std::vector<bool>& fixed() const { return fixed_; }
  /// Whether any node of any rank is fixed, on a surface, or on a spring.
  bool hold_anything() const;
  /// A_a k of springs at each local node for the areas at X, g/s^2; empty without
  /// springs. Local.
  const std::vector<double>& spring_stiffness() const { return spring_stiffness_; }

  /// Takes over the unloaded configuration (ghosts in): areas on which springs act.
  void set_reference(const NodeVector& unloaded);

  /// Puts the nodes of the unloaded `positions` (ghosts included) that are tied to
  /// a surface on their level sets. Those held to one side only have to be let
  /// sink in where the loaded body pulls on them. Local.
  void put_on_surfaces(NodeVector& positions);

  /// Projects a field of owned nodes (displacements or forces of X) to what fixed
  /// nodes and the tangent planes that put_on_surfaces() found allow. Local.
  void project(NodeVector& field) const;

  /// Takes over where the surfaces are at X + u, as tangent planes, for the next
  /// steps. Local.
  void linearize(const NodeVector& unloaded, const NodeVector& displacement);

  /// Adds forces of springs. Owned nodes. Local.
  void add_spring_forces(const NodeVector& displacement, NodeVector& force) const;

  /// Adds forces of springs, and of gradual corrections with masses m and time
  /// step h: m s(v) c / h^2. Owned nodes. Local.
  void add_forces(const NodeVector& displacement, const NodeVector& velocity,
                  const std::vector<double>& mass, double time_step, NodeVector& force) const;

  /// Projects displacement, velocity and force of owned nodes to the tangent
  /// planes. Local.
  void constrain(NodeVector& displacement, NodeVector& velocity, NodeVector& force) const;

  /// Largest distance of a node of X + u, or of X, from its level set, mm; not
  /// counting nodes that may lift off.
  double largest_gap(const NodeVector& unloaded, const NodeVector& displacement) const;

  /// The same supports as forces for Newton's method: surfaces by a penalty of
  /// `contact_stiffness` (Pa/mm) on d(x) - d(X), with the areas of the loaded
  /// configuration. Keeps a reference to this object.
  std::unique_ptr<NodalForce> nodal_force(double contact_stiffness) const;

private:
  struct Contact {
    std::shared_ptr<const Surface> surface;
    ContactLaw law;
    BoundaryIds ids;
  };
  /// One of the contacts of a node that is not fixed.
  struct ContactNode {
    unsigned node; ///< local, may be a ghost
    unsigned contact;
    int before;                    ///< the same node's contact before this one, or -1
    double level;                  ///< distance in the loaded configuration, mm
    dealii::Tensor<1, 3> normal;   ///< of the tangent plane
    double offset = 0.;            ///< gap = offset + normal . u, mm
    dealii::Tensor<1, 3> way_back; ///< unit; the part of the normal across the contacts before
  };
  struct Springs {
    BoundaryIds ids;
    double stiffness; ///< Pa/mm
  };
  class Force;

  void forget_fixed_nodes();
  void link_contacts();
  dealii::Tensor<1, 3> across_earlier(const ContactNode& contact,
                                      const dealii::Tensor<1, 3>& normal) const;

  const Body& body_;
  std::vector<bool> fixed_;
  std::vector<Contact> contacts_;
  std::vector<ContactNode> contact_nodes_;
  std::vector<Springs> springs_;
  std::vector<double> spring_stiffness_;
  ContactMethod method_ = ContactMethod::projection;
  GradualCorrection correction_;
};

} // namespace prosup::mechanics

#endif
