#include "result_fields.h"

#include "prosup/core/error.h"
#include "prosup/core/position.h"
#include "prosup/image/image_io.h"
#include "prosup/image/warp.h"
#include "prosup/output/displacement_fields.h"
#include "prosup/output/registration_file.h"
#include "prosup/pipeline/finished_result.h"
#include "state_map.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

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

/// What moves with the chest from one loaded state to the other is at rest in the unloaded one.
image::VectorImage ResultFields::to_unloaded(const std::string& from) const {
  constexpr double rounding = 2e-3; // mm, of the fields outside of the mesh
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
