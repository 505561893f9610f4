// The experiment of the paper's appendix: a soft box is loaded and unloaded, on
// the same mesh and through voxels. Prints a table and writes box.csv and box.png.

#include <cmath>
#include <cstdio>

#include "../setup.h"
#include "prosup/core/log.h"
#include "prosup/core/text_file.h"
#include "prosup/evaluation/point_mapper.h"
#include "shaded.h"
#include "unload.h"
#include "voxels.h"

using namespace dealii;
using namespace prosup;
using namespace prosup::benchmarks;
using mechanics::NodeVector;

namespace {

/// How the box is loaded, put on voxels and meshed.
struct Case {
  double weight = 1.; ///< in multiples of 9810 mm/s^2
  bool hanging = true;
  double shift = 0.;       ///< of the cube against the voxels, in voxels
  double edge_length = 1.; ///< mm
  double voxel = 0.5;      ///< mm; the paper's
};

std::vector<Case> all_cases() {
  std::vector<Case> cases{{}};
  for (const double shift : {0.25, 0.5})
    cases.push_back({1., true, shift, 1.});
  for (const double edge_length : {0.7, 1.5, 2.})
    cases.push_back({1., true, 0., edge_length});
  cases.push_back({1., true, 0., 0.7, 0.25});
  cases.push_back({0.5, true, 0., 1.});
  cases.push_back({2., true, 0., 1.});
  cases.push_back({0.5, false, 0., 1.});
  cases.push_back({1., false, 0., 1.});
  return cases;
}

/// Numbers of tetrahedra along an edge of the cube.
struct Sizes {
  unsigned truth = 12, same_mesh = 12;
};

struct Outcome {
  mesh::UnloadedMesh truth, recovered;
  std::size_t n_voxels = 0;
  Distances motion, same_mesh, displacement, surface; // mm
};

Outcome run(const Case& what, const Sizes& sizes) {
  BoxExperiment box;
  box.gravity = what.weight * standard_gravity;
  box.direction = Tensor<1, 3>({0., what.hanging ? -1. : 1., 0.});
  const mechanics::Body fine =
      cube_body(box, sizes.truth, {mechanics::ElementType::quadratic}, true);
  Outcome outcome;
  outcome.truth = as_mesh(fine, solve_loaded(box, fine), fine.vertex_positions());
  const image::LabelImage mask = rasterise(outcome.truth.mesh, what.voxel, box.edge, what.shift);
  outcome.recovered = unload_mask(box, mask, what.edge_length);
  const std::vector<double> displacement =
      displacement_errors(mask, outcome.recovered, outcome.truth);
  outcome.n_voxels = displacement.size();
  outcome.displacement = statistics(displacement);
  outcome.surface = statistics(surface_distances(outcome.recovered, box.edge));
  outcome.same_mesh = statistics(same_mesh_errors(box, sizes.same_mesh));
  std::vector<double> motion;
  for (std::size_t i = 0; i < outcome.truth.unloaded.size(); ++i)
    motion.push_back(outcome.truth.unloaded[i].distance(outcome.truth.mesh.points[i]));
  outcome.motion = statistics(motion);
  return outcome;
}

const char* table_head =
    "| box | weight, g | voxel, mm | shift, voxels | edge length, mm | cells | moves, mm "
    "| same mesh: max, mm | "
    "through voxels: max | p95 | mean | surface: max | p95 |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";

std::string row(const Case& what, const Outcome& outcome, const char* pattern) {
  return format(pattern, what.hanging ? "hanging" : "standing", what.weight, what.voxel, what.shift,
                what.edge_length, outcome.recovered.mesh.cells.size(), outcome.motion.max,
                outcome.same_mesh.max, outcome.displacement.max, outcome.displacement.p95,
                outcome.displacement.mean, outcome.surface.max, outcome.surface.p95);
}

void print_volumes(const Outcome& outcome) {
  std::printf(
      "\nVolume of the first: cube %.1f, loaded %.1f, its %zu voxels %.1f, their mesh %.1f, "
      "recovered %.1f mm^3.\n",
      volume(outcome.truth.mesh, outcome.truth.unloaded),
      volume(outcome.truth.mesh, outcome.truth.mesh.points), outcome.n_voxels,
      static_cast<double>(outcome.n_voxels) * std::pow(Case().voxel, 3),
      volume(outcome.recovered.mesh, outcome.recovered.mesh.points),
      volume(outcome.recovered.mesh, outcome.recovered.unloaded));
}

/// Unloaded, loaded and recovered, as the paper's Fig. 12.
void draw(const Outcome& outcome, const std::filesystem::path& file) {
  const mesh::UnloadedMesh &truth = outcome.truth, &recovered = outcome.recovered;
  const evaluation::PointMapper mapper(truth);
  std::vector<Point<3>> material;
  for (const Point<3>& x : recovered.mesh.points)
    material.push_back(mapper.to_unloaded(x));
  write_shaded({{&truth.mesh.cells, truth.unloaded, truth.unloaded},
                {&truth.mesh.cells, truth.mesh.points, truth.unloaded},
                {&recovered.mesh.cells, recovered.unloaded, material}},
               file);
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app{"Loads and unloads a soft box, on one mesh and through voxels.",
               "benchmark_box_experiment"};
  std::filesystem::path folder;
  bool small = false;
  app.add_option("--output", folder, "Folder for box.csv and box.png")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_flag("--small", small, "One case on coarse meshes");
  return run_program(argc, argv, app, [&] {
    const std::vector<Case> cases =
        small ? std::vector<Case>{{1., true, 0., 2.5, 0.5}} : all_cases();
    const Sizes sizes = small ? Sizes{4, 4} : Sizes{};
    std::string csv =
        "box,weight_g,voxel_mm,shift_voxels,edge_length_mm,cells,moves_mm,same_mesh_max_mm,"
        "voxels_max_mm,voxels_p95_mm,voxels_mean_mm,surface_max_mm,surface_p95_mm\n";
    Outcome first;
    std::printf("%s", table_head);
    for (const Case& what : cases) {
      Outcome outcome = run(what, sizes);
      std::printf("%s",
                  row(what, outcome,
                      "| %s | %g | %g | %g | %g | %zu | %.2f | %.5f | %.3f | %.3f | %.3f | %.2f | "
                      "%.2f |\n")
                      .c_str());
      std::fflush(stdout);
      csv += row(what, outcome, "%s,%g,%g,%g,%g,%zu,%.3f,%.5f,%.4f,%.4f,%.4f,%.3f,%.3f\n");
      if (first.n_voxels == 0)
        first = std::move(outcome);
    }
    print_volumes(first);
    write_text_file(csv, folder / "box.csv");
    draw(first, folder / "box.png");
  });
}
