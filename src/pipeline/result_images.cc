#include "prosup/pipeline/result_images.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
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

/// The files of one position; returns its unloaded image.
ScalarImage write_position(Position position, const PerPosition<mesh::UnloadedMesh>& meshes,
                           const ScalarImage& loaded, const image::VoxelGrid& unloaded_grid,
                           const std::filesystem::path& folder) {
  const std::string name = name_of(position), other_name = name_of(other(position));
  const PointMapper mapper(meshes[position]), other_mapper(meshes[other(position)]);
  const image::VectorImage from_unloaded =
      output::unloaded_to_loaded(unloaded_grid, meshes[position], mapper);
  image::write_displacement(from_unloaded, folder / ("unloaded_to_" + name + ".nrrd"));
  image::write_displacement(
      output::loaded_to_loaded(loaded.grid, meshes[position], mapper, other_mapper),
      folder / (name + "_to_" + other_name + ".nrrd"));
  return write_warped(loaded, from_unloaded, folder / (name + "_unloaded.nii.gz"));
}

} // namespace

ScalarImage write_warped(const ScalarImage& original, const image::VectorImage& field,
                         const std::filesystem::path& file) {
  const float darkest = *std::min_element(original.values.begin(), original.values.end());
  ScalarImage warped = image::warp(original, field, darkest);
  image::write_image(warped, file);
  return warped;
}

PerPosition<ScalarImage> write_images(PerPosition<mesh::UnloadedMesh>& meshes,
                                      const PerPosition<registration::OriginalImage>& originals,
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
        images[position] = write_position(position, meshes, originals[position].image,
                                          unloaded_grid({&meshes.prone, &meshes.supine},
                                                        parameters.voxel_edge, parameters.margin),
                                          folder);
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
