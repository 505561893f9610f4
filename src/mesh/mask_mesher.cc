#include "prosup/mesh/mask_mesher.h"

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>

#include "contour.h"
#include "flat_cells.h"
#include "labelling.h"
#include "node_relocation.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "prosup/image/filters.h"
#include "prosup/mesh/quality.h"
#include "surface_remesher.h"
#include "volume_mesher.h"

namespace prosup::mesh {

using namespace dealii;

namespace {

/// Cells of the contour per wanted edge: fine enough to keep the shape, coarse
/// enough to be quick.
constexpr double contour_spacing = 0.6;

/// Smallest height of a cell that is aimed at, over the edge length; 0.82 is
/// that of a regular tetrahedron.
constexpr double wanted_height = 0.5;

/// A mesh with a worse radius ratio than this is as good as inverted.
constexpr double worst_quality = 1e-3;

/// Smallest volume that is worth meshing, in cubes of the edge length.
constexpr double smallest_body = 4.;

/// Largest distance over the edge length by which the surface moves to make up
/// for chords: that of a sphere of one and a half edge lengths.
constexpr double largest_shift = 0.06;

/// The same labels in the frame of the grid: axes along the coordinate axes,
/// voxel 0 at the origin.
image::LabelImage in_grid_frame(const image::LabelImage& labels) {
  image::LabelImage result = labels;
  result.grid = image::VoxelGrid();
  result.grid.size = labels.grid.size;
  result.grid.spacing = labels.grid.spacing;
  return result;
}

image::LabelImage breast_mask(const image::LabelImage& labels,
                              const std::vector<unsigned>& tissue_labels) {
  const image::LabelImage tissue = image::select_labels(labels, tissue_labels);
  if (std::find(tissue.values.begin(), tissue.values.end(), 1) == tissue.values.end())
    throw Error("The label image has no voxel of the tissue labels " + joined(tissue_labels) +
                "; give the labels it uses in 'Labels/Tissues'.");
  return image::fill_holes(image::largest_component(tissue));
}

[[noreturn]] void refuse(double volume, double edge_length) {
  throw Error(format("The breast mask (%.3g ml) is too small or too thin to be meshed with an "
                     "edge length of %g mm; choose a smaller \"Meshing/Edge length\".",
                     1e-3 * volume, edge_length));
}

/// Moves the free surface so that it encloses `volume`: the chords of a convex
/// surface lie inside it, and smoothing shrinks it.
void restore_volume(SurfaceRemesher& remesher, double volume, double largest_shift) {
  double level = 0.;
  for (unsigned iteration = 0; iteration < 2; ++iteration) {
    const TriangleMesh surface = remesher.result();
    const double area = free_area(surface);
    if (area == 0.) // the mask fills the image
      return;
    level += (volume - enclosed_volume(surface)) / area;
    level = std::clamp(level, -largest_shift, largest_shift);
    remesher.move_to_level(level);
  }
}

/// The mesh in the frame of the grid, without tissues and boundary parts. Without
/// cells if it cannot be made at this edge length.
TetMesh mesh_level_set(const LevelSet& phi, double edge_length) {
  const Contour fine = contour(phi, contour_spacing * edge_length);
  if (fine.surface.triangles.empty())
    refuse(phi.mask_volume(), edge_length);
  SurfaceRemesher remesher(fine.surface, phi, edge_length);
  remesher.run();
  restore_volume(remesher, fine.body_fraction * phi.mask_volume(),
                 largest_shift * edge_length + 0.25 * phi.sigma());
  const TriangleMesh surface = remesher.result();
  if (enclosed_volume(surface) < smallest_body * std::pow(edge_length, 3))
    refuse(phi.mask_volume(), edge_length);
  TetMesh mesh = fill_with_tets(surface, edge_length);
  if (mesh.cells.empty())
    return mesh;
  const double height = wanted_height * edge_length;
  const std::vector<unsigned> patches = node_patches(surface);
  improve_worst_cells(mesh, patches, remesher.projection(), height);
  if (peel_flat_cells(mesh, 0.7 * height) > 0)
    improve_worst_cells(mesh, patches, remesher.projection(), height);
  return measure_quality(mesh).min_quality > worst_quality ? mesh : TetMesh();
}

/// As above; where thin parts of the mask make it fail, once more with shorter edges.
TetMesh mesh_with_patience(const LevelSet& phi, double edge_length) {
  for (const double part : {1., 0.8, 0.64}) {
    TetMesh mesh = mesh_level_set(phi, part * edge_length);
    if (!mesh.cells.empty())
      return mesh;
  }
  throw Error(format("gmsh could not fill the breast surface with tetrahedra of edge length %g mm; "
                     "choose a smaller \"Meshing/Edge length\", or correct thin parts of the mask.",
                     edge_length));
}

/// Moves a mesh from the frame of the grid to physical space.
void to_physical(TetMesh& mesh, const image::VoxelGrid& grid) {
  for (Point<3>& x : mesh.points)
    x = grid.origin + grid.direction * x;
  if (determinant(grid.direction) > 0.)
    return;
  for (auto& cell : mesh.cells)
    std::swap(cell[2], cell[3]);
  for (BoundaryFace& face : mesh.boundary_faces)
    std::swap(face.nodes[1], face.nodes[2]);
}

} // namespace

MaskMesher::MaskMesher(const Labels& labels) : ParameterAcceptor("Meshing"), labels_(labels) {}

void MaskMesher::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Edge length", edge_length,
                    "h, edge length that the tetrahedra should have. Units: mm.",
                    Patterns::Double(0.1, 100.));
  prm.add_parameter("Smoothing", smoothing,
                    "sigma/s, standard deviation of the Gaussian that smooths the distance to the "
                    "mask, over the cube root s of the volume of a voxel. A value of 1 removes the "
                    "stair steps of the voxels. Units: none.",
                    Patterns::Double(0., 10.));
}

TetMesh MaskMesher::mesh(const image::LabelImage& labels) const {
  labels_.check();
  const image::LabelImage upright = in_grid_frame(labels);
  const LevelSet phi(breast_mask(upright, labels_.tissues),
                     smoothing * std::cbrt(labels.grid.voxel_volume()));
  TetMesh result = mesh_with_patience(phi, edge_length);
  result.tissue = sample_tissue(result, upright, labels_.tissues);
  result.boundary_faces = find_boundary(result, upright, labels_);
  to_physical(result, labels.grid);
  return result;
}

} // namespace prosup::mesh
