#include "state_map.h"

#include <algorithm>

#include "prosup/core/text.h"
#include "prosup/pipeline/finished_result.h"

namespace prosup::pipeline {

using dealii::Point;
using evaluation::Configuration;
using evaluation::DepthGauge;
using evaluation::MappedPoint;

namespace {

Position position_of(const std::string& state) {
  return state == name_of(Position::supine) ? Position::supine : Position::prone;
}

DepthGauge gauge_of(const mesh::UnloadedMesh& mesh, const std::string& state) {
  return {mesh.mesh, state == unloaded_state ? mesh.unloaded : mesh.mesh.points};
}

} // namespace

const std::vector<std::string>& state_names() {
  static const std::vector<std::string> names{name_of(Position::prone), name_of(Position::supine),
                                              unloaded_state};
  return names;
}

StateMap::StateMap(const std::filesystem::path& result, std::string from, std::string to)
    : from_(std::move(from)),
      to_(std::move(to)), meshes_{read_breast(result, name_of(Position::prone)),
                                  read_breast(result, name_of(Position::supine))},
      mappers_{evaluation::PointMapper(meshes_.prone), evaluation::PointMapper(meshes_.supine)},
      from_gauge_(gauge_of(meshes_[breast_before()], from_)),
      to_gauge_(gauge_of(meshes_[breast_after()], to_)) {}

Position StateMap::breast_before() const {
  return position_of(from_ == unloaded_state ? to_ : from_);
}

Position StateMap::breast_after() const {
  return position_of(to_ == unloaded_state ? from_ : to_);
}

MappedState StateMap::operator()(const Point<3>& point) const {
  MappedState mapped{point, point, 0.};
  if (from_ != unloaded_state) {
    const MappedPoint found = mapper(position_of(from_)).map(point, Configuration::loaded);
    mapped.unloaded = found.position;
    mapped.outside = found.distance_outside;
  }
  if (goes_nowhere()) {
    if (from_ == unloaded_state)
      mapped.outside = mapper(Position::prone).distance_outside(point, Configuration::unloaded);
    return mapped;
  }
  mapped.position = mapped.unloaded;
  if (to_ != unloaded_state) {
    const MappedPoint found =
        mapper(position_of(to_)).map(mapped.unloaded, Configuration::unloaded);
    mapped.position = found.position;
    mapped.outside = std::max(mapped.outside, found.distance_outside);
  }
  return mapped;
}

double StateMap::volume_ratio(const Point<3>& unloaded) const {
  if (goes_nowhere())
    return 1.;
  const auto J = [&](const std::string& state) {
    return state == unloaded_state ? 1. : mapper(position_of(state)).place(unloaded).volume_ratio;
  };
  return J(to_) / J(from_);
}

void OutsideReport::look_at(const std::string& name, double outside) {
  constexpr std::size_t most_named = 20;
  ++n_points_;
  if (outside <= evaluation::far_outside)
    return;
  farthest_ = std::max(farthest_, outside);
  if (++n_outside_ <= most_named)
    named_.push_back("'" + shown(name) + "'");
}

void OutsideReport::say(Remarks& remarks) const {
  if (n_outside_ == 0)
    return;
  const std::size_t n_more = n_outside_ - named_.size();
  remarks.add(
      format("%zu of %zu points lie more than %g mm outside the mesh, up to %.1f mm (%s%s); "
             "they were moved with the closest point of the mesh.",
             n_outside_, n_points_, evaluation::far_outside, farthest_, joined(named_).c_str(),
             n_more > 0 ? format(" and %zu more", n_more).c_str() : ""));
}

} // namespace prosup::pipeline
