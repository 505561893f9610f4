#ifndef PROSUP_MESH_LABELLING_H
#define PROSUP_MESH_LABELLING_H

#include "prosup/core/labels.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

// `labels` in the frame of the mesh.

/// The label of each cell: the most frequent tissue label among sample points
/// in the cell, or that of the tissue voxel nearest to its centroid.
std::vector<std::uint8_t> sample_tissue(const TetMesh& mesh, const image::LabelImage& labels,
                                        const std::vector<unsigned>& tissue_labels);

/// The faces of one cell only, normals outwards: cut planes in the outer faces
/// of the image and where the way outwards meets what is unknown before another
/// label, chest wall where it meets the chest, else skin.
std::vector<BoundaryFace> find_boundary(const TetMesh& mesh, const image::LabelImage& labels,
                                        const Labels& meaning);

} // namespace prosup::mesh

#endif
