#ifndef PROSUP_REGISTRATION_ELEMENT_BREAST_H
#define PROSUP_REGISTRATION_ELEMENT_BREAST_H

#include <memory>
#include <optional>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/body/supports.h"
#include "prosup/registration/breast.h"
#include "prosup/registration/breast_model.h"
#include "prosup/registration/breast_state.h"
#include "prosup/similarity/element_samples.h"
#include "prosup/unloading/unloading.h"

namespace prosup::registration {

/// A breast of tetrahedra under explicit dynamics.
class ElementBreast : public Breast {
public:
  /// A body with what holds and moves it. A host program that has meshes of its own makes them
  /// itself; make_element_breast() makes them from labels.
  struct Parts {
    std::unique_ptr<mechanics::Body> body;
    std::unique_ptr<mechanics::Supports> supports;
    std::unique_ptr<unloading::Unloading> unloading;
    mesh::TetMesh
        mesh; ///< that of Body::cells() on the first rank; empty if mesh() is not asked for
    mesh::TetMesh coarse{}; ///< where the body was made of a coarser one (quadratic elements)
    dealii::Tensor<1, 3> gravity{};     ///< direction without tilt; 0: what `unloading` has is kept
    std::vector<std::string> remarks{}; ///< what is doubtful about it, each a sentence
  };

  /// Keeps a reference to the material.
  ElementBreast(Position position, Parts parts, const mechanics::TissueMaterial& material);

  bool has_gland() const override;
  bool knows_gravity() const override { return parts_.gravity.norm() > 0.; }
  void set_properties(const MechanicalProperties& properties) override;

  settling::SettlingResult unload(const settling::Effort& effort = {}) override;
  settling::SettlingResult load() override;
  settling::SettlingResult advance(double duration) override;
  void save() override;
  void restore() override;

  similarity::Box unloaded_box() const override;
  bool samples_surroundings() const override { return false; }
  const similarity::Samples& sample(const similarity::SimilarityDomain& domain,
                                    const image::ScalarImage& image) override;
  void set_image_forces(const std::vector<float>& slope, similarity::Variable variable) override;
  void add_image_forces(double weight, double momentum, double ramp) override;
  void forget_momentum() override { increment_ = {}; }

  mesh::UnloadedMesh mesh() const override;

  /// What it goes on from; with fields of the nodes that this rank owns. Collective.
  BreastState state() const;
  /// Goes on from there, with the properties as they are. The state has to tell of the nodes that
  /// this rank owns; more do no harm. Collective.
  /// @throws Error if it does not, or is of another mesh.
  void resume(const BreastState& state);
  /// Numbers at the nodes of `nodes` in a field of BreastState, and the field of the nodes that
  /// this rank owns. Collective.
  std::vector<double> rows_of(const mechanics::NodeVector& field) const;
  mechanics::NodeVector field_of(const std::vector<unsigned>& nodes,
                                 const std::vector<double>& rows) const;

  ElementBreast* elements() override { return this; }
  const mechanics::Body& body() const { return *parts_.body; }
  mechanics::Supports& supports() { return *parts_.supports; }
  unloading::Unloading& unloading() { return *parts_.unloading; }
  const unloading::Unloading& unloading() const { return *parts_.unloading; }
  /// Of the elements, for the present properties.
  const mechanics::Material& material() const { return material_of_elements_; }

private:
  /// Number of each local node in the mesh.
  const std::vector<unsigned>& node_numbers() const;

  const Position position_;
  Parts parts_;
  const mechanics::TissueMaterial& material_;
  mechanics::Material material_of_elements_;
  std::optional<unloading::Unloading::Snapshot> saved_;
  std::optional<similarity::ElementSamples> samples_;
  mechanics::NodeVector image_forces_, increment_;
  bool is_loaded_ = false;                     // by load()
  mutable std::vector<unsigned> node_numbers_; // once they were asked for
};

/// Meshes the labels of a breast, on the first rank of `communicator`, and sets up its body.
/// Collective. @throws as make_breast().
std::unique_ptr<ElementBreast> make_element_breast(const BreastModel& model,
                                                   const BreastInput& input, MPI_Comm communicator);

} // namespace prosup::registration

#endif
