#include "result_fields.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/position.h"
#include "prosup/image/image_io.h"
#include "prosup/image/warp.h"
#include "prosup/mesh/scan_conversion.h"
#include "prosup/output/displacement_fields.h"
#include "prosup/output/registration_file.h"
#include "prosup/pipeline/finished_result.h"
#include "state_map.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

namespace {

constexpr double rounding = 2e-3; // mm, of the fields outside of the mesh

/// Whether the voxel of a field that is closest to a point moves with the chest.
bool is_chest(const image::VectorImage& field, const image::RigidTransform& rigid,
              const dealii::Point<3>& x) {
  const dealii::Point<3> index = field.grid.continuous_index(x);
  std::array<std::size_t, 3> at{};
  for (unsigned d = 0; d < 3; ++d)
    at[d] = std::size_t(std::lround(std::clamp(index[d], 0., double(field.grid.size[d]) - 1.)));
  const dealii::Point<3> voxel = field.grid.physical(double(at[0]), double(at[1]), double(at[2]));
  const auto& u = field(at[0], at[1], at[2]);
  return (voxel + dealii::Tensor<1, 3>({u[0], u[1], u[2]})).distance(rigid(voxel)) < rounding;
}

} // namespace

ResultFields::ResultFields(fs::path result) : result_(std::move(result)) {
  if (!fs::is_directory(result_))
    throw Error("'" + result_.string() +
                "' is no folder, but images and models need the displacement fields in the "
                "--output folder of prosup register; give that folder.");
  require_finished(result_);
  const fs::path h5 = result_ / output::registration_h5;
  const auto alignment =
      fs::exists(h5) ? output::read_alignment(h5) : std::optional<image::RigidTransform>();
  if (!alignment)
    throw Error("The result '" + result_.string() +
                "' does not tell how the chests were aligned, since an earlier version wrote it; "
                "register again.");
  supine_to_prone_ = *alignment;
}

image::RigidTransform ResultFields::chest_motion(const std::string& from,
                                                 const std::string& to) const {
  const std::string supine = name_of(Position::supine);
  if (from == to || (from != supine && to != supine))
    return {};
  return from == supine ? supine_to_prone_ : supine_to_prone_.inverse();
}

image::VectorImage ResultFields::read(const std::string& from, const std::string& to) const {
  return image::read_displacement(result_ / (from + "_to_" + to + ".nrrd"));
}

image::VectorImage ResultFields::field(const std::string& from, const std::string& to) const {
  return to == unloaded_state ? to_unloaded(from) : read(from, to);
}

image::VectorImage ResultFields::field_on(const image::VoxelGrid& grid, const std::string& from,
                                          const std::string& to) const {
  const image::RigidTransform rigid = chest_motion(from, to);
  const image::VectorImage own = this->field(from, to);
  image::VectorImage field = image::resampled(own, grid, rigid);
  const StateMap map(result_, from, to);
  const mesh::UnloadedMesh& breast = map.mesh(map.breast_before());
  const auto& nodes = from == unloaded_state ? breast.unloaded : breast.mesh.points;
  for (const auto& cell : breast.mesh.cells)
    mesh::scan_convert_tet(grid, {nodes[cell[0]], nodes[cell[1]], nodes[cell[2]], nodes[cell[3]]},
                           [&](std::size_t i, std::size_t j, std::size_t k, const auto&) {
                             const dealii::Point<3> x =
                                 grid.physical(double(i), double(j), double(k));
                             if (is_chest(own, rigid, x))
                               return;
                             const dealii::Tensor<1, 3> moved = map(x).position - x;
                             for (unsigned d = 0; d < 3; ++d)
                               field(i, j, k)[d] = static_cast<float>(moved[d]);
                           });
  return field;
}

/// What moves with the chest from one loaded state to the other is at rest in the unloaded one.
image::VectorImage ResultFields::to_unloaded(const std::string& from) const {
  const std::string other_state =
      name_of(from == name_of(Position::prone) ? Position::supine : Position::prone);
  const image::VectorImage to_other = read(from, other_state);
  const image::RigidTransform rigid = chest_motion(from, other_state);
  const image::FieldSampler sampler(to_other, rigid);
  const auto is_chest = [&](const dealii::Point<3>& x) {
    return (x + sampler(x)).distance(rigid(x)) < rounding;
  };
  const mesh::UnloadedMesh mesh = read_breast(result_, from);
  return output::loaded_to_unloaded(to_other.grid, mesh, evaluation::PointMapper(mesh),
                                    {chest_motion(from, unloaded_state), is_chest})
      .displacement;
}

} // namespace prosup::pipeline
