#include "prosup/pipeline/result_images.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "prosup/core/collective.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "prosup/mesh/transfer.h"
#include "prosup/output/displacement_fields.h"
#include "prosup/output/radius_image.h"
#include "prosup/pipeline/unloaded_grid.h"

namespace prosup::pipeline {

using evaluation::PointMapper;
using image::ScalarImage;

namespace {

/// What lies beyond the field of view gets the darkest value.
ScalarImage warped_on_air(const ScalarImage& original, const image::VectorImage& field) {
  const float darkest = *std::min_element(original.values.begin(), original.values.end());
  return image::warp(original, field, darkest);
}

/// What the files of one position are made from.
struct Sources {
  const PerPosition<mesh::UnloadedMesh>& meshes;
  const registration::Inputs& inputs;
  const ResultParameters& parameters;
};

/// The chest of a position, which is at rest in the unloaded state, whose coordinates are those of
/// the prone image.
output::RigidChest chest_of(Position position, bool is_loaded, const Sources& from) {
  const similarity::Scene& scene = from.inputs.scene;
  const image::RigidTransform &to_prone = from.inputs.alignment, to_supine = to_prone.inverse();
  const bool is_supine = position == Position::supine;
  output::RigidChest chest;
  if (is_loaded)
    chest.motion = is_supine ? to_prone : to_supine;
  else if (is_supine)
    chest.motion = to_supine;
  chest.contains = output::voxels_with(scene.labels[position], scene.chest_label,
                                       is_loaded && is_supine ? to_prone : image::RigidTransform());
  return chest;
}

/// A warped image as precise as the original: with integers if that holds integers, which files
/// pack in a fraction of the time and space.
ScalarImage as_precise(const ScalarImage& original, const image::VectorImage& field) {
  ScalarImage warped = warped_on_air(original, field);
  if (std::all_of(original.values.begin(), original.values.end(),
                  [](float value) { return value == std::round(value); }))
    for (float& value : warped.values)
      value = std::round(value);
  return warped;
}

/// The field from one position to the other, and what is made with it.
void write_to_other(Position position, const PointMapper& mapper, const Sources& from,
                    const std::filesystem::path& folder) {
  const std::string name = name_of(position), other_name = name_of(other(position));
  const image::VoxelGrid& grid = from.inputs.originals[position].image.grid;
  const output::StateField field = output::loaded_to_loaded(
      grid, from.meshes[position], mapper, PointMapper(from.meshes[other(position)]),
      chest_of(position, true, from));
  image::write_displacement(field.displacement, folder / (name + "_to_" + other_name + ".nrrd"));
  image::write_labels(field.valid, folder / ("valid_" + name + ".nii.gz"));
  if (from.parameters.other_states)
    image::write_image(as_precise(from.inputs.originals[other(position)].image, field.displacement),
                       folder / (other_name + "_in_" + name + ".nii.gz"));
}

/// The files of one position; returns its unloaded image.
ScalarImage write_position(Position position, const Sources& from,
                           const std::filesystem::path& folder) {
  const std::string name = name_of(position);
  const mesh::UnloadedMesh& mesh = from.meshes[position];
  const PointMapper mapper(mesh);
  write_to_other(position, mapper, from, folder);
  const image::VoxelGrid grid = unloaded_grid({&from.meshes.prone, &from.meshes.supine},
                                              from.parameters.voxel_edge, from.parameters.margin);
  const output::StateField field =
      output::unloaded_to_loaded(grid, mesh, mapper, chest_of(position, false, from));
  image::write_displacement(field.displacement, folder / ("unloaded_to_" + name + ".nrrd"));
  image::write_labels(field.valid, folder / ("valid_unloaded_" + name + ".nii.gz"));
  return write_warped(from.inputs.originals[position].image, field.displacement,
                      folder / (name + "_unloaded.nii.gz"));
}

} // namespace

ScalarImage write_warped(const ScalarImage& original, const image::VectorImage& field,
                         const std::filesystem::path& file) {
  ScalarImage warped = warped_on_air(original, field);
  image::write_image(warped, file);
  return warped;
}

PerPosition<ScalarImage> write_images(PerPosition<mesh::UnloadedMesh>& meshes,
                                      const registration::Inputs& inputs,
                                      const ResultParameters& parameters,
                                      const std::filesystem::path& folder,
                                      const registration::RankSplit& ranks) {
  const int rank = dealii::Utilities::MPI::this_mpi_process(ranks.world());
  const int second = ranks.first_rank(Position::supine);
  if (rank == 0 || rank == second)
    for (const Position position : both_positions)
      mesh::transfer(meshes[position], 0, second, ranks.world());
  PerPosition<ScalarImage> images;
  on_every_rank(ranks.world(), [&] {
    for (const Position position : both_positions)
      if (rank == ranks.first_rank(position))
        images[position] = write_position(position, {meshes, inputs, parameters}, folder);
  });
  if (rank == 0 || rank == second)
    transfer(images.supine.values, second, 0, ranks.world());
  if (rank == 0)
    images.supine.grid = images.prone.grid;
  return images;
}

void write_radius_image(const PerPosition<mesh::UnloadedMesh>& meshes,
                        const evaluation::Uncertainty::Covariances& covariances,
                        const ResultParameters& parameters, const std::filesystem::path& folder) {
  const image::VoxelGrid grid =
      unloaded_grid({&meshes.prone, &meshes.supine}, parameters.voxel_edge, parameters.margin);
  image::write_image(output::radius_image(grid, meshes, covariances),
                     folder / "unloaded_radius_95.nii.gz");
}

} // namespace prosup::pipeline
