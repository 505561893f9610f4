#ifndef PROSUP_REGISTRATION_BREAST_H
#define PROSUP_REGISTRATION_BREAST_H

#include <memory>
#include <vector>

#include "prosup/mesh/tet_mesh.h"
#include "prosup/registration/mechanical_properties.h"
#include "prosup/settling/effort.h"
#include "prosup/settling/settling_result.h"
#include "prosup/similarity/samples.h"

namespace prosup::registration {

class ElementBreast;

/// One breast in one position, simulated by some numerical method: the loaded shape is that of the
/// image, the unloaded one is sought. Everything that a registration does to a breast, and all that
/// it sees of one. All functions are collective on the ranks that the breast was made on.
class Breast {
public:
  virtual ~Breast() = default;

  /// Whether it has gland as well as fat.
  virtual bool has_gland() const = 0;
  /// Whether the tilt of gravity among its properties has an effect.
  virtual bool knows_gravity() const { return false; }
  /// Goes on from the present state with other properties.
  virtual void set_properties(const MechanicalProperties& properties) = 0;

  /// Removes gravity: simulates until settled. @throws DivergenceError if it does not settle; the
  /// last good state is restored.
  virtual settling::SettlingResult unload(const settling::Effort& effort = {}) = 0;
  /// Adds gravity: takes the shape that it was made with as the unloaded one. @throws as unload().
  virtual settling::SettlingResult load() = 0;
  /// Simulates for `duration` times the damping time, the inverse of r/rho. @throws as unload().
  virtual settling::SettlingResult advance(double duration) = 0;

  /// Keeps the present state in place of the one kept before.
  virtual void save() = 0;
  /// Goes back to the state that was kept.
  virtual void restore() = 0;

  /// A box around the unloaded tissue, as far as this rank knows it.
  virtual similarity::Box unloaded_box() const = 0;
  /// Whether sample() knows what every voxel shows, air and chest wall too. If not, it samples the
  /// tissue alone.
  virtual bool samples_surroundings() const = 0;
  /// The image of the loaded breast at the unloaded voxels of `domain`, in the present state.
  /// Valid until the next call.
  virtual const similarity::Samples& sample(const similarity::SimilarityDomain& domain,
                                            const image::ScalarImage& image) = 0;
  /// Takes over the image forces on the voxels sampled last, for dS/dP_v = `slope`.
  virtual void set_image_forces(const std::vector<float>& slope, similarity::Variable variable) = 0;
  /// Adds `weight` (Pa) times these forces and `momentum` times what was added last; they rise from
  /// 0 over `ramp` damping times.
  virtual void add_image_forces(double weight, double momentum, double ramp) = 0;
  /// Forgets what was added last.
  virtual void forget_momentum() = 0;

  /// Both configurations on the first rank; empty on others.
  virtual mesh::UnloadedMesh mesh() const = 0;

  /// This breast if it consists of finite elements, else null: what the schemes of image forces
  /// need that minimise an energy.
  virtual ElementBreast* elements() { return nullptr; }
};

} // namespace prosup::registration

#endif
