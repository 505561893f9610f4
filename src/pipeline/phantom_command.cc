#include <deal.II/base/mpi.h>

#include "phantom_truth.h"
#include "prosup/core/collective.h"
#include "prosup/core/parameters.h"
#include "prosup/core/result_folder.h"
#include "prosup/evaluation/landmarks_csv.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "prosup/mesh/quality.h"
#include "prosup/output/displacement_fields.h"
#include "prosup/output/pictures.h"
#include "prosup/output/summary.h"
#include "prosup/phantom/grids.h"
#include "prosup/phantom/landmarks.h"
#include "prosup/phantom/phantom_body.h"
#include "prosup/phantom/state_images.h"
#include "prosup/pipeline/body_building.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/stage_timer.h"

namespace prosup::pipeline {

using phantom::LoadedPhantom;
using similarity::state_names;

namespace {

namespace fs = std::filesystem;

constexpr unsigned unloaded = 2; // the third state, besides 0 prone and 1 supine

/// Images of a phantom and their truth, on all ranks of a communicator: all
/// work together on the two loaded states, the first one makes the images.
class PhantomJob {
public:
  PhantomJob(const Stages& stages, MPI_Comm world)
      : stages_(stages), parameters_(stages.phantom), world_(world), log_(world),
        timer_(world, log_) {}

  void run(const dealii::ParameterHandler& parameters, const fs::path& output) {
    std::unique_ptr<ResultFolder> folder;
    on_every_rank(world_, [&] { check(); });
    on_root(world_, [&] { folder = std::make_unique<ResultFolder>(output); });
    timer_.run("Meshing", [&] { build(); });
    timer_.run("Loading", [&] { load(); });
    timer_.run("Making images", [&] {
      on_root(world_, [&] {
        write_parameters(parameters, folder->path() / "used.prm");
        write(folder->path());
      });
    });
    const double memory = peak_memory(world_);
    on_root(world_, [&] {
      output::write_summary(summary(memory), folder->path() / "summary.json");
      folder->commit();
      log_.line("\n" + timer_.table() + "\n\nResults are in " + output.string());
    });
  }

private:
  void check() {
    parameters_.anatomy.geometry.check();
    for (const unsigned state : {0u, 1u})
      grids_[state] = phantom::image_grid(parameters_.anatomy.geometry, parameters_.images,
                                          both_positions[state]);
    grids_[unloaded] = grids_[0];
  }

  void build() {
    anatomy_ = std::make_unique<phantom::Anatomy>(
        parameters_.anatomy.geometry, parameters_.anatomy.gland_fraction, parameters_.seed);
    body_ = std::make_unique<phantom::PhantomBody>(parameters_.mechanics, *anatomy_, world_);
    log_.line(format("  %u quadratic tetrahedra, %u nodes, volume %.1f ml",
                     body_->body().n_global_cells() / 8, n_global_nodes(body_->body()),
                     parameters_.anatomy.geometry.volume() / 1000.));
  }

  void load() {
    for (const unsigned state : {0u, 1u}) {
      phantom::Load load;
      load.body_force = body_force(stages_, state);
      load.push_pressure = state == 0 ? parameters_.mechanics.push_pressure : 0.;
      loaded_[state] = body_->load(load, stages_.quasi_static, log_);
      log_.line(describe(state_names[state], loaded_[state].result));
    }
  }

  void write(const fs::path& folder) {
    const phantom::Texture texture(*anatomy_, parameters_.seed);
    for (const unsigned state : {0u, 1u}) {
      write_field(state, folder);
      write_images(state, loaded_[state].mesh, texture, folder);
    }
    const mesh::UnloadedMesh& prone = loaded_[0].mesh;
    mesh::TetMesh at_rest = prone.mesh;
    at_rest.points = prone.unloaded;
    write_images(unloaded, {at_rest, prone.unloaded}, texture, folder);
    const auto landmarks = phantom::sample_landmarks(
        parameters_.anatomy.geometry, {loaded_[0].mesh, loaded_[1].mesh}, {grids_[0], grids_[1]},
        parameters_.n_landmarks, parameters_.seed);
    evaluation::write_landmarks(landmarks, folder / "landmarks.csv");
    initial_error_ = evaluation::initial_error(landmarks);
    write_phantom_truth(stages_, initial_error_, {loaded_[0].result, loaded_[1].result},
                        folder / "truth.json");
    log_.line(format("  %zu landmarks, distance prone to supine: mean %.1f mm, max %.1f mm",
                     initial_error_.n, initial_error_.mean, initial_error_.max));
    if (stages_.results.pictures)
      write_pictures(folder);
  }

  void write_field(unsigned state, const fs::path& folder) const {
    const mesh::UnloadedMesh& mesh = loaded_[state].mesh;
    image::write_displacement(
        output::unloaded_to_loaded(grids_[unloaded], mesh, evaluation::PointMapper(mesh)),
        folder / (std::string("unloaded_to_") + state_names[state] + ".nrrd"));
  }

  /// The unloaded image has the modality of the prone one.
  void write_images(unsigned state, const mesh::UnloadedMesh& mesh, const phantom::Texture& texture,
                    const fs::path& folder) {
    const unsigned seen_as = state == unloaded ? 0 : state;
    const std::string name = state == unloaded ? "unloaded" : state_names[state];
    const auto points = phantom::material_points(grids_[state], mesh);
    const phantom::StateImages images(*anatomy_, points, parameters_.seed, state);
    images_[state] = images.image(
        texture, parameters_.images.modality(both_positions[seen_as]),
        {parameters_.images.noise(both_positions[seen_as]), parameters_.images.bias_field});
    const image::LabelImage labels = state == unloaded
                                         ? images.labels()
                                         : images.jittered_labels(parameters_.images.label_jitter);
    image::write_image(images_[state], folder / (name + ".nii.gz"));
    image::write_labels(labels, folder / (name + "_labels.nii.gz"));
    masks_[state] = image::select_labels(labels, {phantom::fat, phantom::gland});
  }

  void write_pictures(const fs::path& folder) const {
    std::vector<output::Panel> row;
    for (const unsigned state : {0u, unloaded, 1u})
      row.push_back({state == unloaded ? "unloaded" : state_names[state],
                     {&images_[state], image::robust_range(images_[state], masks_[state], 1., 99.)},
                     {}});
    for (output::Panel& panel : row) // air and lung are below all tissue
      panel.shown.window.low -= 0.3 * (panel.shown.window.high - panel.shown.window.low);
    output::write_slices({row}, output::slice_box({&masks_[0], &masks_[1]}), folder);
  }

  output::Summary summary(double memory) const {
    output::Summary summary;
    summary.command = "phantom";
    summary.ranks = dealii::Utilities::MPI::n_mpi_processes(world_);
    for (const unsigned state : {0u, 1u}) {
      const mesh::MeshQuality quality = mesh::measure_quality(loaded_[state].mesh.mesh);
      (state == 0 ? summary.prone : summary.supine) =
          output::StateSummary{quality.n_cells,
                               quality.n_nodes,
                               quality.min_quality,
                               loaded_[state].result.min_jacobian,
                               {}};
    }
    summary.shear_modulus = parameters_.mechanics.fat_shear_modulus;
    summary.tre.initial = initial_error_;
    summary.time.mesh = timer_.seconds("Meshing");
    summary.time.total = timer_.total();
    summary.peak_memory = memory;
    summary.converged = loaded_[0].result.converged && loaded_[1].result.converged;
    return summary;
  }

  const Stages& stages_;
  const phantom::PhantomParameters& parameters_;
  MPI_Comm world_;
  const Log log_;
  StageTimer timer_;
  std::array<image::VoxelGrid, 3> grids_;
  std::unique_ptr<phantom::Anatomy> anatomy_;
  std::unique_ptr<phantom::PhantomBody> body_;
  std::array<LoadedPhantom, 2> loaded_;
  std::array<image::ScalarImage, 3> images_;
  std::array<image::LabelImage, 3> masks_;
  evaluation::ErrorStatistics initial_error_;
};

} // namespace

void run_phantom(const Stages& stages, const dealii::ParameterHandler& parameters,
                 const std::filesystem::path& output, MPI_Comm world) {
  PhantomJob(stages, world).run(parameters, output);
}

} // namespace prosup::pipeline
