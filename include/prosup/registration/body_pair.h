#ifndef PROSUP_REGISTRATION_BODY_PAIR_H
#define PROSUP_REGISTRATION_BODY_PAIR_H

#include <mpi.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "prosup/image/voxel_image.h"
#include "prosup/mechanics/laws/tissue_material.h"
#include "prosup/registration/simulated_pair.h"
#include "prosup/similarity/image_force.h"
#include "prosup/unloading/unloading.h"

namespace prosup::registration {

using similarity::State;

/// Shares the ranks of a communicator between the two states, which need each
/// other only when images are compared: with two or more ranks, the first half
/// (rounded up) works on prone and the others on supine; one rank does both.
class RankSplit {
public:
  explicit RankSplit(MPI_Comm world);
  ~RankSplit();
  RankSplit(const RankSplit&) = delete;
  RankSplit& operator=(const RankSplit&) = delete;

  MPI_Comm world() const { return world_; }
  /// The ranks that work on the same state(s) as this one.
  MPI_Comm group() const { return group_; }
  bool holds(State state) const { return holds_[state]; }
  /// Rank in world() of the first rank that works on a state.
  int first_rank(State state) const { return first_rank_[state]; }

  /// Tells all ranks the results of the two states, which those that hold them know.
  std::array<settling::SettlingResult, 2>
  share(std::array<settling::SettlingResult, 2> results) const;

private:
  MPI_Comm world_;
  MPI_Comm group_;
  std::array<bool, 2> holds_{};
  std::array<int, 2> first_rank_{};
};

/// One state of the breast, where this rank works on it.
struct BodyState {
  std::unique_ptr<mechanics::Body> body;
  std::unique_ptr<mechanics::Supports> supports;
  std::unique_ptr<unloading::Unloading> unloading;
  image::ScalarImage image; ///< loaded, intensities scaled to [0, 1]
  /// Of each element, or a single one, Pa; as of BodyPair::set_properties().
  mechanics::Material material;
};

/// Prone and supine with all that the registration does to both alike. Every
/// function is collective on the communicator of the split, and throws on all
/// its ranks if one state fails.
class BodyPair {
public:
  explicit BodyPair(const RankSplit& ranks) : ranks_(ranks) {}

  const RankSplit& ranks() const { return ranks_; }

  BodyState& operator[](State state) { return states_[state]; }
  const BodyState& operator[](State state) const { return states_[state]; }

  /// Calls `work` for each state that this rank holds.
  void for_each(const std::function<void(State, BodyState&)>& work);

  /// Gives both states the same tissue and the same bed.
  void set_properties(const mechanics::TissueMaterial& material,
                      const MechanicalProperties& properties);
  bool has_gland(const mechanics::TissueMaterial& material) const;
  const MechanicalProperties& properties() const { return properties_; }

  /// Runs both unloadings until settled, or at most `max_steps` steps if not 0.
  std::array<settling::SettlingResult, 2> unload(unsigned max_steps = 0);

  /// Both states with their own loaded images, for the similarity.
  std::array<similarity::LoadedState, 2> loaded_states() const;
  /// The same with other images (a pyramid level), null where not held.
  std::array<similarity::LoadedState, 2>
  loaded_states(const std::array<image::ScalarImage, 2>& images) const;

  using Snapshot = std::array<std::unique_ptr<unloading::Unloading::Snapshot>, 2>;
  Snapshot save() const;
  void restore(const Snapshot& snapshot);

private:
  const RankSplit& ranks_;
  std::array<BodyState, 2> states_;
  MechanicalProperties properties_;
};

} // namespace prosup::registration

#endif
