#include <deal.II/base/mpi.h>

#include "prosup/core/collective.h"
#include "prosup/core/log.h"
#include "prosup/core/parameters.h"
#include "prosup/core/result_folder.h"
#include "prosup/mesh/quality.h"
#include "prosup/output/summary.h"
#include "prosup/output/vtu.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/stage_timer.h"

namespace prosup::pipeline {

namespace {

std::string report(const mesh::MeshQuality& quality) {
  return format("  %zu cells, %zu nodes, volume %.1f ml\n"
                "  quality (radius ratio): min %.3f, mean %.3f, %.2f%% below 0.2\n"
                "  edges: mean %.2f mm, shortest %.2f mm; smallest height %.2f mm; largest aspect "
                "%.1f",
                quality.n_cells, quality.n_nodes, quality.volume_mm3 / 1000., quality.min_quality,
                quality.mean_quality, 100. * quality.fraction_below_02, quality.mean_edge,
                quality.min_edge, quality.min_height, quality.max_aspect);
}

} // namespace

void run_mesh(const Stages& stages, const dealii::ParameterHandler& parameters,
              const std::filesystem::path& output, MPI_Comm world) {
  const Log log(world);
  StageTimer timer(world, log);
  const unsigned state = stages.scene.state();
  output::Summary summary;
  summary.command = "mesh";
  summary.ranks = dealii::Utilities::MPI::n_mpi_processes(world);
  summary.peak_memory = peak_memory(world);
  on_root(world, [&] {
    ResultFolder folder(output);
    mesh::TetMesh mesh;
    const image::LabelImage labels = stages.inputs.read_labels(stages.scene, state);
    const auto start = std::chrono::steady_clock::now();
    log.line("Meshing");
    mesh = stages.mesher.mesh(labels);
    summary.time.mesh =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const mesh::MeshQuality quality = mesh::measure_quality(mesh);
    log.line(report(quality));
    (state == 0 ? summary.prone : summary.supine) =
        output::StateSummary{quality.n_cells, quality.n_nodes, quality.min_quality, {}, {}};
    summary.converged = true;
    summary.time.total = timer.total();
    output::write_mesh({mesh, mesh.points}, folder.path(), similarity::state_names[state]);
    write_parameters(parameters, folder.path() / "used.prm");
    output::write_summary(summary, folder.path() / "summary.json");
    folder.commit();
    log.line("\nResults are in " + output.string());
  });
}

} // namespace prosup::pipeline
