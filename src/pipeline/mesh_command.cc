#include "prosup/core/collective.h"
#include "prosup/core/log.h"
#include "prosup/mesh/quality.h"
#include "prosup/output/vtu.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/result_run.h"
#include "prosup/registration/completed_labels.h"

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

bool run_mesh(const AllParameters& parameters, const dealii::ParameterHandler& all,
              const ResultTarget& output, MPI_Comm world) {
  ResultRun run("mesh", all, output, world);
  const CaseParameters& given = parameters.case_files;
  const Position position = given.position();
  image::LabelImage labels;
  mesh::TetMesh mesh;
  run.stage("Reading", [&] {
    on_root(world, [&] {
      given.require_labels(position);
      labels =
          parameters.registration.images.read_breast(given.files(), position, run.remarks()).labels;
      const registration::SceneCheck& checks = parameters.registration.checks;
      checks.check_one(labels, position).tell(run.remarks());
      std::vector<std::string> remarks;
      labels = registration::completed_labels(
          labels, position, parameters.registration.labels.chest,
          parameters.registration.labels.unknown, run.log(), remarks);
      for (const std::string& remark : remarks)
        run.remarks().add(remark);
    });
  });
  run.stage("Meshing",
            [&] { on_root(world, [&] { mesh = parameters.model().mesher.mesh(labels); }); });
  run.stage("Writing results", [&] {
    on_root(world, [&] {
      const mesh::MeshQuality quality = mesh::measure_quality(mesh);
      run.log().line(report(quality));
      auto& breast = run.summary().breasts[position].emplace();
      breast.n_cells = quality.n_cells;
      breast.n_nodes = quality.n_nodes;
      breast.min_quality = quality.min_quality;
      output::write_mesh({mesh, mesh.points}, run.folder(), name_of(position));
    });
  });
  run.summary().time.mesh = run.seconds("Meshing");
  run.summary().converged = true;
  return run.finish();
}

} // namespace prosup::pipeline
