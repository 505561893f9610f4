#ifndef PROSUP_REGISTRATION_REGISTRATION_H
#define PROSUP_REGISTRATION_REGISTRATION_H

#include <mpi.h>

#include <memory>
#include <optional>

#include "prosup/core/log.h"
#include "prosup/core/remarks.h"
#include "prosup/registration/agreement.h"
#include "prosup/registration/breast_model.h"
#include "prosup/registration/breast_pair.h"
#include "prosup/registration/image_force_registration.h"
#include "prosup/registration/inputs.h"
#include "prosup/registration/material_update.h"
#include "prosup/registration/pre_alignment.h"
#include "prosup/registration/registration_state.h"
#include "prosup/registration/scene_check.h"
#include "prosup/registration/uncertainty.h"
#include "prosup/similarity/similarity_parameters.h"

namespace prosup::registration {

/// Everything that a registration can be told, section by section, with defaults. The values come
/// from prosup::read_parameters().
struct RegistrationParameters {
  Labels labels;
  InputReader images{labels};
  PreAlignment pre_alignment;
  SceneCheck checks{labels};
  BreastModel model{labels};
  similarity::SimilarityParameters similarity;
  MaterialUpdate material_update;
  ImageForceRegistration image_forces;
  UncertaintyParameters uncertainty;
};

/// What a registration has found.
struct RegistrationResult {
  /// Loaded and unloaded positions of both breasts on rank 0, empty elsewhere. Loaded positions are
  /// in the coordinates of the original images, LPS mm; evaluation::PointMapper maps points with
  /// them.
  PerPosition<mesh::UnloadedMesh> meshes;
  MechanicalProperties properties;
  bool converged = false; ///< all simulations settled
};

/// Registers the prone and the supine image of one breast: read(), unload(), match_properties(),
/// match_images() and result(), in this order; the two matches may be left out. Everything is
/// collective on `world`, and throws on all of its ranks alike.
class Registration {
public:
  /// Keeps a reference to the parameters. `log` is told of the progress.
  explicit Registration(const RegistrationParameters& parameters, MPI_Comm world = MPI_COMM_WORLD,
                        const Log& log = Log());

  /// Replaces the metric that the parameters name.
  void set_metric(std::shared_ptr<const similarity::Metric> metric) { metric_ = std::move(metric); }
  /// Replaces the mesher; `mesher` has to live on.
  void set_mesh_source(const mesh::MeshSource& mesher) { mesher_ = &mesher; }
  /// Is told of each state that the registration goes on from.
  void set_observer(Observer observer) { observer_ = std::move(observer); }

  /// Reads images and labels. What is doubtful goes to `remarks` of rank 0, or else to the log.
  /// @throws Error for input that cannot be used.
  void read(const CaseFiles& files, Remarks& remarks);
  /// The same, with remarks to the log.
  void read(const CaseFiles& files);
  /// Removes gravity from both breasts, with the properties that the parameters give.
  /// @throws Error if a breast cannot be meshed, DivergenceError if one does not settle.
  PerPosition<settling::SettlingResult> unload();
  /// Searches the mechanical properties with which the unloaded breasts agree best.
  MaterialUpdateResult match_properties();
  /// Pushes the unloaded breasts together with image forces.
  ImageForceResult match_images();
  /// Whether the images are compared by a metric that needs the same contrast.
  bool compares_same_contrast() const { return metric_->needs_same_contrast(); }
  /// How far the unloaded breasts agree as they are now.
  Agreement agreement(bool with_intensities = true) const {
    return measure_agreement(*pair_, compared(), with_intensities);
  }
  /// As it is now.
  RegistrationResult result() const;
  /// How sure the unloaded positions are after match_images(), at the nodes of the meshes of
  /// result(), mm^2, on rank 0. Empty if this is not wanted or not known, as after forces that were
  /// accumulated.
  UncertaintyParameters::Covariances covariances() const;

  /// Whether it can be kept and resumed: breasts of finite elements can.
  bool has_state() const;
  /// What it goes on from. To be asked for between the calls above, or by a keeper.
  RegistrationState state() const;
  /// Goes on from there, after read() of the same files with the same parameters, on any number of
  /// ranks. The calls above then do what the state has not done yet.
  /// @throws Error if the state does not fit.
  void resume(const RegistrationState& state);
  Stage stage() const { return stage_; }
  /// Is told of each point within a stage from which it could go on.
  void set_keeper(Keeper keeper) { keeper_ = std::move(keeper); }

  /// Two parts of unload(), which does what the host has not done yet, for instance to time it.
  /// Lays the supine chest on the prone one if the parameters ask for it.
  void align();
  /// What is wrong with the scene as it is aligned now, on rank 0; throws nothing for it.
  SceneReport check() const;
  /// Meshes both breasts, or what else the numerical method starts with.
  void build();

  /// Which ranks work on which breast.
  const RankSplit& ranks() const { return ranks_; }
  /// What read() has read, as align() has moved it.
  const Inputs& inputs() const { return inputs_; }
  /// What align() found, on rank 0.
  const std::optional<Alignment>& alignment() const { return alignment_; }
  /// Those that the breasts have now.
  const MechanicalProperties& properties() const { return pair_->properties(); }

private:
  ComparedImages compared() const;
  PerPosition<dealii::Tensor<1, 3>> gravity() const;
  PerPosition<settling::SettlingResult> unload_stiff_enough();
  void make_pair(const PerPosition<const mesh::MeshSource*>& meshers);

  const RegistrationParameters& parameters_;
  const Log log_;
  const RankSplit ranks_;
  std::shared_ptr<const similarity::Metric> metric_;
  const mesh::MeshSource* mesher_ = nullptr;
  Observer observer_;
  CaseFiles files_;
  Inputs inputs_;
  bool is_aligned_ = false;
  std::optional<Alignment> alignment_;
  std::unique_ptr<BreastPair> pair_;
  bool converged_ = true;
  Stage stage_ = Stage::nothing;
  Stage resumed_ = Stage::nothing; // stages up to here were done before resume()
  PerPosition<settling::SettlingResult> unloaded_;
  MaterialProgress material_;
  ImageForceProgress forces_;
  Keeper keeper_ = [] {};
};

} // namespace prosup::registration

#endif
