#ifndef PROSUP_MECHANICS_SUPPORTS_H
#define PROSUP_MECHANICS_SUPPORTS_H

#include <memory>
#include <vector>

#include "prosup/mechanics/body/contact_surfaces.h"

namespace prosup::mechanics {

/// Everything that holds a body: boundaries that do not move, surfaces along which nodes slide,
/// and springs
///   f_a = -A_a k (x_a - X_a),
/// with the area A_a lumped to the node in the unloaded configuration and k in Pa/mm, which may
/// differ from face to face. Fixed nodes neither slide nor feel springs. All functions are
/// collective on the communicator of the body unless they are said to be local.
class Supports {
public:
  /// The nodes of the boundaries `fixed` do not move.
  explicit Supports(const Body& body, const BoundaryIds& fixed = {});

  /// The nodes of these boundaries do not move; with a filter, those of faces that pass it.
  void fix(const BoundaryIds& ids, const FaceFilter& counts = {});
  /// These local nodes do not move any more from where they are, in whatever way they were held
  /// before. The same on all ranks that share a node.
  void hold(const std::vector<bool>& nodes);
  /// The nodes of these boundaries slide, see ContactSurfaces::add.
  void slide_on(std::shared_ptr<const Surface> surface, const BoundaryIds& ids, ContactLaw law,
                double least_alignment = 0.);
  /// Adds springs of `stiffness` (Pa/mm) to these boundaries; with a filter, to faces that pass it.
  void add_springs(const BoundaryIds& ids, double stiffness, const FaceFilter& counts = {});
  /// Gives each face with springs on this boundary an exponent, 0 without it, for
  /// set_springs_on(). Local.
  void grade_springs_on(dealii::types::boundary_id id, const FaceValue& exponent);
  /// Changes the stiffness of all springs on this boundary to k ratio^s, with k in Pa/mm and the
  /// exponent s of each face, from the next set_reference() on. Local.
  void set_springs_on(dealii::types::boundary_id id, double stiffness, double ratio = 1.);

  const Body& body() const { return body_; }
  /// Whether each local node is fixed. Local.
  const std::vector<bool>& fixed() const { return fixed_; }
  /// Whether any node of any rank is fixed, on a surface, or on a spring.
  bool hold_anything() const;
  ContactSurfaces& contacts() { return contacts_; }
  const ContactSurfaces& contacts() const { return contacts_; }

  /// Sets the unloaded configuration (ghosts in), on whose areas springs act.
  void set_reference(const NodeVector& unloaded);
  /// A_a k of the springs at each local node, g/s^2; empty without springs. Local.
  const std::vector<double>& spring_stiffness() const { return spring_stiffness_; }
  /// A face of Body::boundary_faces() with springs of this stiffness, Pa/mm.
  struct SpringFace {
    std::size_t face;
    double stiffness;
  };
  /// All faces with springs; some may occur twice. Local.
  std::vector<SpringFace> spring_faces() const;
  /// Adds the forces of the springs at owned nodes. Local.
  void add_spring_forces(const NodeVector& displacement, NodeVector& force) const;

  /// Projects a field of owned nodes (displacements or forces of X) to what fixed nodes and the
  /// tangent planes of ContactSurfaces::put_on_surfaces() allow. Local.
  void project(NodeVector& field) const;

private:
  struct Springs {
    BoundaryIds ids;
    std::vector<std::size_t> faces; ///< numbers in Body::boundary_faces()
    double stiffness;               ///< k, Pa/mm
    double ratio = 1.;
    std::vector<double> exponents; ///< of the faces; empty: 0

    std::vector<double> weights() const; ///< ratio^exponent of the faces; empty: 1
  };

  const Body& body_;
  std::vector<bool> fixed_;
  ContactSurfaces contacts_;
  std::vector<Springs> springs_;
  std::vector<double> spring_stiffness_;
};

} // namespace prosup::mechanics

#endif
