#ifndef PROSUP_PIPELINE_RESULT_IMAGES_H
#define PROSUP_PIPELINE_RESULT_IMAGES_H

#include <filesystem>

#include "prosup/evaluation/error_bar.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"
#include "prosup/pipeline/result_parameters.h"
#include "prosup/registration/inputs.h"
#include "prosup/registration/rank_split.h"

namespace prosup::pipeline {

/// Warps an original image by `field` and writes it to `file`. What lies beyond
/// its field of view gets its darkest value, which is air in MR and CT alike.
image::ScalarImage write_warped(const image::ScalarImage& original, const image::VectorImage& field,
                                const std::filesystem::path& file);

/// Writes the four displacement fields with masks of where they are valid, both unloaded images,
/// and each image as it would look in the other position, to `folder`: those of each position by
/// the first rank that works on it, so that two ranks share the work. The meshes come from rank 0
/// and go to the other. Collective; returns the unloaded images on rank 0.
PerPosition<image::ScalarImage> write_images(PerPosition<mesh::UnloadedMesh>& meshes,
                                             const registration::Inputs& inputs,
                                             const ResultParameters& parameters,
                                             const std::filesystem::path& folder,
                                             const registration::RankSplit& ranks);

/// Writes output::radius_image() on the grid of the unloaded images. For one rank.
void write_radius_image(const PerPosition<mesh::UnloadedMesh>& meshes,
                        const evaluation::Uncertainty::Covariances& covariances,
                        const ResultParameters& parameters, const std::filesystem::path& folder);

} // namespace prosup::pipeline

#endif
