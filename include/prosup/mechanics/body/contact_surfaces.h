#ifndef PROSUP_MECHANICS_CONTACT_SURFACES_H
#define PROSUP_MECHANICS_CONTACT_SURFACES_H

#include <memory>
#include <vector>

#include "prosup/mechanics/body/boundary.h"
#include "prosup/mechanics/body/surface.h"

namespace prosup::mechanics {

/// How nodes are kept on a surface along which they may slide.
enum class ContactLaw {
  tied,     ///< they stay on it
  one_sided ///< they may lift off but not sink in
};

/// How the contact law is enforced in an explicit step.
enum class ContactMethod {
  projection, ///< position, velocity and force are projected to the tangent plane
  gradual     ///< eq. 10 and 11 of the paper: small corrections of limited speed
};

/// The correction s(v) = p / (1 + exp(l (v - v_max))), l = 10 ln 9 / v_max, of the paper (eq. 11).
/// Applied in every step, it acts like a spring of stiffness m p/h^2: a loaded node stays off the
/// surface by its load over this stiffness. The paper's p = 0.005 belongs to the short steps of
/// its fine grid; the steps here are more than ten times longer.
struct GradualCorrection {
  double part = 0.5;         ///< p, of the distance to the surface in a step
  double speed_limit = 500.; ///< v_max, mm/s
};

/// The surfaces along which nodes of a body slide. A node keeps the level set of the surface on
/// which it lies in the loaded configuration, in the unloaded configuration too. Functions act on
/// the nodes of this rank unless they are said to be collective.
class ContactSurfaces {
public:
  /// A surface and the boundaries that slide on it.
  struct Contact {
    std::shared_ptr<const Surface> surface;
    ContactLaw law;
    BoundaryIds ids;
  };
  /// A node on one of the surfaces.
  struct Node {
    unsigned node;                 ///< local, may be a ghost
    unsigned contact;              ///< index in surfaces()
    int before;                    ///< the entry of the same node before this one, or -1
    double level;                  ///< distance in the loaded configuration, mm
    dealii::Tensor<1, 3> normal;   ///< of the tangent plane
    double offset = 0.;            ///< gap = offset + normal . u, mm
    dealii::Tensor<1, 3> way_back; ///< unit; the part of the normal across the entries before
  };

  explicit ContactSurfaces(const Body& body) : body_(body) {}

  /// The nodes of these boundaries slide on `surface`. Only those faces count whose normal makes
  /// an angle with that of the surface of which the cosine is at least `least_alignment`.
  /// Collective.
  void add(std::shared_ptr<const Surface> surface, const BoundaryIds& ids, ContactLaw law,
           double least_alignment);
  /// These local nodes do not slide any more.
  void remove(const std::vector<bool>& nodes);
  /// `correction` is that of ContactMethod::gradual.
  void set_method(ContactMethod method, const GradualCorrection& correction);

  /// Whether all nodes are kept on their surfaces in both configurations.
  bool ties_exactly() const;

  const std::vector<Contact>& surfaces() const { return contacts_; }
  const std::vector<Node>& nodes() const { return nodes_; }

  /// Moves the nodes of the unloaded `positions` (ghosts included) that are tied to a surface to
  /// their level sets. One-sided contacts are left out: where the loaded body pulls on them, the
  /// unloaded nodes have to be free to sink in.
  void put_on_surfaces(NodeVector& positions);

  /// Removes from a field of owned nodes (displacements or forces of X) what is not tangential to
  /// the planes that put_on_surfaces() found.
  void project(NodeVector& field) const;

  /// Sets the tangent planes at X + u for the next steps.
  void linearize(const NodeVector& unloaded, const NodeVector& displacement);

  /// Adds the forces m s(v) gap / h^2 of gradual corrections, with masses m (g) and time step h
  /// (s), at owned nodes.
  void add_correction_forces(const NodeVector& displacement, const NodeVector& velocity,
                             const std::vector<double>& mass, double time_step,
                             NodeVector& force) const;

  /// Projects displacement, velocity and force of owned nodes to the tangent planes.
  void constrain(NodeVector& displacement, NodeVector& velocity, NodeVector& force) const;

  /// Largest distance of a node of X + u, or of X, from its level set, mm, without nodes that may
  /// lift off. Collective.
  double largest_gap(const NodeVector& unloaded, const NodeVector& displacement) const;

private:
  void link_nodes();
  dealii::Tensor<1, 3> across_earlier(const Node& node, const dealii::Tensor<1, 3>& normal) const;

  const Body& body_;
  std::vector<Contact> contacts_;
  std::vector<Node> nodes_;
  ContactMethod method_ = ContactMethod::projection;
  GradualCorrection correction_;
};

} // namespace prosup::mechanics

#endif
