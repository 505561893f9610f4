#include "prosup/pipeline/result_images.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <string>

#include "prosup/core/collective.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "prosup/output/displacement_fields.h"
#include "prosup/pipeline/body_building.h"
#include "prosup/pipeline/unloaded_grid.h"

namespace prosup::pipeline {

using evaluation::PointMapper;
using image::ScalarImage;
using registration::State;
using similarity::prone;
using similarity::supine;

namespace {

/// The files of one state; returns its unloaded image.
ScalarImage write_state(State state, const std::array<mesh::UnloadedMesh, 2>& unloaded,
                        const ScalarImage& loaded, const image::VoxelGrid& unloaded_grid,
                        const std::filesystem::path& folder) {
  const State other = state == prone ? supine : prone;
  const std::string name = similarity::state_names[state];
  const PointMapper mapper(unloaded[state]), other_mapper(unloaded[other]);
  const image::VectorImage from_unloaded =
      output::unloaded_to_loaded(unloaded_grid, unloaded[state], mapper);
  image::write_displacement(from_unloaded, folder / ("unloaded_to_" + name + ".nrrd"));
  image::write_displacement(
      output::loaded_to_loaded(loaded.grid, unloaded[state], mapper, other_mapper),
      folder / (name + "_to_" + similarity::state_names[other] + ".nrrd"));
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

std::array<ScalarImage, 2> write_images(std::array<mesh::UnloadedMesh, 2>& unloaded,
                                        const std::array<OriginalImage, 2>& originals,
                                        const ResultParameters& parameters,
                                        const std::filesystem::path& folder,
                                        const registration::RankSplit& ranks) {
  const int rank = dealii::Utilities::MPI::this_mpi_process(ranks.world());
  const int second = ranks.first_rank(supine);
  if (rank == 0 || rank == second)
    for (mesh::UnloadedMesh& mesh : unloaded)
      transfer_unloaded(mesh, 0, second, ranks.world());
  std::array<ScalarImage, 2> images;
  on_every_rank(ranks.world(), [&] {
    for (const State state : {prone, supine})
      if (rank == ranks.first_rank(state))
        images[state] = write_state(state, unloaded, originals[state].image,
                                    unloaded_grid({&unloaded[prone], &unloaded[supine]},
                                                  parameters.voxel_edge, parameters.margin),
                                    folder);
  });
  if (rank == 0 || rank == second)
    transfer(images[supine].values, second, 0, ranks.world());
  if (rank == 0)
    images[supine].grid = images[prone].grid;
  return images;
}

} // namespace prosup::pipeline
