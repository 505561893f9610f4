#ifndef PROSUP_SRC_PIPELINE_STATE_MAP_H
#define PROSUP_SRC_PIPELINE_STATE_MAP_H

#include <deal.II/base/point.h>

#include <filesystem>
#include <string>
#include <vector>

#include "prosup/core/position.h"
#include "prosup/core/remarks.h"
#include "prosup/evaluation/depth.h"
#include "prosup/evaluation/point_mapper.h"

namespace prosup::pipeline {

/// The name of the state without gravity; those of the others are the names of the positions.
constexpr const char* unloaded_state = "unloaded";

/// The states of a registration, as users name them.
const std::vector<std::string>& state_names();

/// A point that was mapped from one state to another.
struct MappedState {
  dealii::Point<3> position, unloaded; ///< LPS, mm
  double outside; ///< distance from the mesh that it is further away from, mm; 0 inside of both
};

/// A finished registration as a map from one state to another. Points outside of a mesh move with
/// its closest point.
class StateMap {
public:
  /// The states are of state_names(). @throws Error as read_breast().
  StateMap(const std::filesystem::path& result, std::string from, std::string to);

  MappedState operator()(const dealii::Point<3>& point) const;

  /// J = det dx_to/dx_from of the tissue with this unloaded position.
  double volume_ratio(const dealii::Point<3>& unloaded) const;

  evaluation::Depth depth_before(const dealii::Point<3>& point) const { return from_gauge_(point); }
  evaluation::Depth depth_after(const dealii::Point<3>& point) const { return to_gauge_(point); }

  const evaluation::PointMapper& mapper(Position position) const { return mappers_[position]; }
  const mesh::UnloadedMesh& mesh(Position position) const { return meshes_[position]; }

  const std::string& from() const { return from_; }
  const std::string& to() const { return to_; }

  /// The breast whose state the points come from, and that whose they go to. In the unloaded state
  /// both are told from each other by the other state.
  Position breast_before() const;
  Position breast_after() const;

private:
  bool goes_nowhere() const { return from_ == to_; }

  const std::string from_, to_;
  const PerPosition<mesh::UnloadedMesh> meshes_;
  const PerPosition<evaluation::PointMapper> mappers_;
  const evaluation::DepthGauge from_gauge_, to_gauge_;
};

/// Says which points lie more than evaluation::far_outside from the mesh.
class OutsideReport {
public:
  void look_at(const std::string& name, double outside);
  void say(Remarks& remarks) const;

private:
  std::size_t n_outside_ = 0, n_points_ = 0;
  double farthest_ = 0.;
  std::vector<std::string> named_;
};

} // namespace prosup::pipeline

#endif
