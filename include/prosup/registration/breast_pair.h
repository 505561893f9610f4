#ifndef PROSUP_REGISTRATION_BREAST_PAIR_H
#define PROSUP_REGISTRATION_BREAST_PAIR_H

#include <functional>
#include <memory>

#include "prosup/registration/breast.h"
#include "prosup/registration/rank_split.h"

namespace prosup::registration {

/// The prone and the supine breast of one patient, each on its half of the ranks. All functions
/// are collective on the world of the ranks, and throw on all of them if one breast fails.
class BreastPair {
public:
  /// Makes the breast of a position on the communicator of its group.
  using Maker = std::function<std::unique_ptr<Breast>(Position, MPI_Comm)>;

  /// `properties` are those that the breasts are given by `make`. Keeps a reference to the ranks.
  BreastPair(const RankSplit& ranks, const MechanicalProperties& properties, const Maker& make);

  const RankSplit& ranks() const { return ranks_; }
  /// The breast of a position that this rank holds.
  Breast& operator[](Position position) const { return *breasts_[position]; }

  /// Calls `work` for each breast that this rank holds.
  void for_each(const std::function<void(Position, Breast&)>& work) const;

  /// Whether `is_so` holds for both breasts. Collective on the world.
  bool all(const std::function<bool(Breast&)>& is_so) const;
  /// Whether Breast::elements() is there for both.
  bool consists_of_elements() const;
  /// Whether either breast has gland.
  bool has_gland() const;
  /// Those that both breasts have now.
  const MechanicalProperties& properties() const { return properties_; }
  /// Gives both breasts the same tissue and the same bed.
  void set_properties(const MechanicalProperties& properties);

  /// Breast::unload() and Breast::advance() of both.
  PerPosition<settling::SettlingResult> unload(const settling::Effort& effort = {});
  PerPosition<settling::SettlingResult> advance(double duration);

  /// Breast::save() and Breast::restore() of both.
  void save();
  void restore();

  /// Both meshes on rank 0 of the world, empty elsewhere, in the coordinates of the breasts.
  PerPosition<mesh::UnloadedMesh> meshes() const;

private:
  const RankSplit& ranks_;
  MechanicalProperties properties_;
  PerPosition<std::unique_ptr<Breast>> breasts_; // null where not held
};

} // namespace prosup::registration

#endif
